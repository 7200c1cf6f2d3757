// What people read: no controls, no exceptions of libraries, suggestions that help.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/program_test.h"
#include "ui/command_line/options.h"
#include "ui/command_line/usage_error.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/suggestion.h"

namespace {

using ui::plain;
using ui::printable;

TEST(Printable, HasNoControlsAndIsUtf8) {
    EXPECT_EQ(printable("a\tb\nc é 語 😀"), "a\tb\nc é 語 😀");
    EXPECT_EQ(printable("\x1b[31m\r\x7f"), "\\x1b[31m\\x0d\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m")
        << "C1";
    EXPECT_EQ(printable("\xc2\xa0"), "\xc2\xa0") << "not C1 any more";
    EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
    // Alone, cut off, overlong, a surrogate, beyond Unicode.
    EXPECT_EQ(printable("\xff\x80"), "\\xff\\x80");
    EXPECT_EQ(printable("\xe8\xaa"), "\\xe8\\xaa");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(Plain, SaysNothingOfTheInsidesOfLibraries) {
    EXPECT_EQ(plain("no mesh: CGAL ERROR: assertion violation!\nExpr: e->is_valid()\nFile: /usr/include/CGAL/x.h"),
              "no mesh: its faces cannot be resolved exactly");
    EXPECT_EQ(plain("CGAL ERROR: precondition violation!"), "its faces cannot be resolved exactly");
    EXPECT_EQ(plain("[json.exception.parse_error.101] parse error at line 1"), "not JSON: parse error at line 1");
    EXPECT_EQ(plain("anything else"), "anything else");
}

TEST(Suggestion, PrefersWhatBeginsAlikeAndNamesSeveral) {
    const std::vector<std::string> names = {"--m",       "--imgsize", "--o",           "--d",
                                            "--samples", "--summary", "--summary-file"};
    EXPECT_EQ(ui::suggestion("--img", names), " Did you mean \"--imgsize\"?");
    EXPECT_EQ(ui::suggestion("--summ", names), " Did you mean \"--summary\" or \"--summary-file\"?");
    EXPECT_EQ(ui::suggestion("--sampels", names), " Did you mean \"--samples\"?");
    EXPECT_EQ(ui::suggestion("--xyz", names, " No."), " No.") << "as good as nothing is alike";
    EXPECT_EQ(ui::suggestion("--", names, " No."), " No.");
}

TEST(Options, AnEmptyValueSwitchesNothingOff) {
    const auto error = [](const std::vector<std::string>& arguments) {
        try {
            (void)ui::read_command_line(arguments);
        } catch (const ui::UsageError& problem) {
            return std::string(problem.what());
        }
        return std::string();
    };
    for (const char* const option : {"--time-limit", "--memory-limit", "--cache", "--imgsize", "--layers", "--samples",
                                     "--colorscheme", "--check-parameters", "--camera", "--stats", "-p", "-d"}) {
        EXPECT_NE(error({"m.scad", "-o", "m.png", option, ""}).find("is empty"), std::string::npos) << option;
    }
    EXPECT_EQ(error({"m.scad", "-o", ""}), "-o: the value is empty");
    EXPECT_NE(error({"m.scad", "-o", "m.png", "--time-limit="}), "");
    EXPECT_NE(error({"m.scad", "-o", "m.png", "--time-limit", "1e300"}).find("at most 1000000000 seconds"),
              std::string::npos);
    EXPECT_EQ(error({"m.scad", "-o", "m.png", "--render"}), "");
}

class Folders : public test_support::ProgramTest {
  protected:
    Folders() : ProgramTest(60) {}
};

TEST_F(Folders, ThatCannotBeMadeAreSaidPlainly) {
    folder_.write("file", "");
    const Result kept = run("m.scad -o x.off --cache file/below");
    EXPECT_EQ(kept.status, 0);
    EXPECT_NE(kept.err.find("the mesh is not kept: file/below: this folder cannot be made: Not a directory"),
              std::string::npos)
        << kept.err;
    const Result report = run("compare m.scad --views 1 --imgsize 32 --report file");
    EXPECT_EQ(report.status, 1);
    EXPECT_EQ(report.err, "csgscope: error: file: this folder cannot be made: Not a directory\n");
    // The folder that it runs in is gone.
    const std::string gone =
        "mkdir gone; cd gone; rmdir ../gone; \"" CSGSCOPE_PROGRAM "\" \"" + folder_.path("m.scad") + "\" -o x.csg";
    EXPECT_EQ(run_program("/bin/sh", "-c '" + gone + "'").err,
              "csgscope: error: x.csg: cannot be created: No such file or directory\n");
}

class Names : public test_support::ProgramTest {
  protected:
    Names() : ProgramTest(60) {}
};

TEST_F(Names, ReachTheTerminalWithoutControls) {
    folder_.write("x.scad", "import(\"\x1b[2J\xff.stl\");\nx = undeclared\x1b;\n");
    EXPECT_EQ(run("x.scad -o x.csg").err.find('\x1b'), std::string::npos);
    folder_.write("y.scad", "import(\"\x1b[2J\xc2\x9b.stl\");\n");
    const Result result = run("y.scad -o y.stl");
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.find_first_of("\x1b\x9b"), std::string::npos) << result.err;
    EXPECT_EQ(run("'\x1b[1mz' -o y.stl").err.find('\x1b'), std::string::npos);
    // What a model echoes is its own affair.
    folder_.write("e.scad", "echo(chr(27));\n");
    EXPECT_NE(run("e.scad -o e.csg").err.find('\x1b'), std::string::npos);
}

TEST_F(Names, ThatAreNoUtf8MakeGoodFiles) {
    const std::string name = "bad\xff\x1b.scad";
    folder_.write(name, "cube(1);\n");
    ASSERT_EQ(run("'" + name + "' -o x.amf -o x.3mf -o x.pdf.stl -d x.d --stats s.json --summary-file u.json").status,
              0);
    EXPECT_NE(folder_.read("x.amf").find("bad\\xff\\x1b.scad"), std::string::npos) << folder_.read("x.amf");
    EXPECT_NE(folder_.read("x.d").find("bad\xff"), std::string::npos) << "make goes by the bytes";
    ASSERT_EQ(run("compare '" + name + "' --imgsize 20 --report report").status, 0);
    const std::string page = folder_.read("report/report.html");
    EXPECT_NE(page.find("bad\\xff\\x1b.scad"), std::string::npos);
    EXPECT_EQ(page.find('\xff'), std::string::npos);
    EXPECT_EQ(folder_.read("report/report.json").find('\xff'), std::string::npos);
}

}  // namespace
