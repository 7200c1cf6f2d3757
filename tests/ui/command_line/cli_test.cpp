// Runs the program as its users do.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "base/image.h"
#include "npr/style.h"
#include "tests/support/program_test.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

class Cli : public test_support::ProgramTest {
  protected:
    Cli() : ProgramTest(60) {}
};

void expect_error(const test_support::ProgramTest::Result& result, const std::string& message) {
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << "expected \"" << message << "\" in:\n" << result.err;
    EXPECT_EQ(result.out, "");
}

TEST_F(Cli, DrawsAPngOfTheSizeAskedFor) {
    const Result result = run("m.scad -o m.png --imgsize=80,60");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "") << "nothing is said on a pipe";
    const base::Image image = base::read_png(folder_.path("m.png"));
    EXPECT_EQ(image.width, 80);
    EXPECT_EQ(image.height, 60);
    EXPECT_NE(std::vector<int>(image.pixel(40, 30), image.pixel(40, 30) + 3),
              std::vector<int>(image.pixel(0, 0), image.pixel(0, 0) + 3))
        << "the model is in the middle";
}

TEST_F(Cli, TheSameTwiceGivesTheSameBytes) {
    ASSERT_EQ(run("m.scad -o a.png -o b.png --imgsize=64,64 --style blueprint").status, 0);
    ASSERT_EQ(run("m.scad -o c.png --imgsize=64,64 --style blueprint").status, 0);
    EXPECT_FALSE(folder_.read("a.png").empty());
    EXPECT_EQ(folder_.read("a.png"), folder_.read("b.png"));
    EXPECT_EQ(folder_.read("a.png"), folder_.read("c.png"));
}

TEST_F(Cli, EglAndOsmesaDrawTheSame) {
    ASSERT_EQ(run("m.scad -o a.png --imgsize=64,64 --context osmesa").status, 0);
    const Result egl = run("m.scad -o b.png --imgsize=64,64 --context egl --stats s.json");
    if (egl.status != 0 || folder_.read("s.json").find("llvmpipe") == std::string::npos) {
        GTEST_SKIP() << "EGL is not the software renderer that OSMesa is";
    }
    EXPECT_EQ(base::read_png(folder_.path("a.png")).rgba, base::read_png(folder_.path("b.png")).rgba);
}

TEST_F(Cli, EveryStyleDrawsItsOwnPicture) {
    std::map<std::string, std::string> pictures;
    for (const npr::StyleInfo& info : npr::styles()) {
        const std::string style(info.name);
        const Result result = run("m.scad -o " + style + ".png --imgsize=48,48 --style " + style);
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(pictures.emplace(folder_.read(style + ".png"), style).second)
            << style << " draws what another draws";
    }
}

TEST_F(Cli, EveryStyleDoesWithoutOpenGl) {
    for (const npr::StyleInfo& info : npr::styles()) {
        const std::string style(info.name);
        const Result result =
            run("m.scad -o " + style + ".png --imgsize=48,48 --context none --stats s.json --style " + style);
        ASSERT_EQ(result.status, 0) << result.err;
        const std::string figures = folder_.read("s.json");
        EXPECT_NE(figures.find("\"painter\": \"cpu\""), std::string::npos) << style;
        EXPECT_NE(figures.find("\"context\": \"none\""), std::string::npos) << style;
    }
    EXPECT_NE(run("m.scad -o x.png --context none --engine goldfeather").status, 0);
}

TEST_F(Cli, WhatIsWrittenOfStylesNamesAllOfThem) {
    std::string help, manual, readme;
    const auto styles = npr::styles();
    for (const npr::StyleInfo& info : styles) {
        const bool first = &info == &styles.front(), last = &info == &styles.back();
        help += fmt::format("{}{}", first ? "" : last ? " or " : ", ", info.name);
        manual += fmt::format("{}{}{}", first ? "" : last ? " or " : ", ", info.name, first ? " (default)" : "");
        readme += fmt::format("{}{}", first ? "" : "\\|", info.name);
    }
    // The help breaks its lines.
    const std::string said = std::regex_replace(run("--help").out, std::regex("\\s+"), " ");
    EXPECT_NE(said.find("--style STYLE " + help + " (" + std::string(styles.front().name) + ")"), std::string::npos);
    const fs::path root = CSGSCOPE_SOURCE_DIR;
    EXPECT_NE(test_support::read_file(root / "docs/csgscope.1").find("\n" + manual + ".\n"), std::string::npos)
        << manual;
    EXPECT_NE(test_support::read_file(root / "README.md").find("`--style " + readme + "`"), std::string::npos)
        << readme;
}

TEST_F(Cli, TheTimeLimitEndsDrawing) {
    // Quick to evaluate, and many seconds to draw.
    folder_.write(
        "heavy.scad",
        "difference() { cube(20); for (x = [0:19], y = [0:19], z = [0:4]) translate([x, y, z] + [.5, .5, .5]) "
        "sphere(.7, $fn = 24); }\n");
    const Result result =
        run("heavy.scad -o h.png --imgsize=3000,3000 --layers 1 --style sketch --samples 16 --time-limit 0.5");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("--time-limit: not done after 0.5 seconds"), std::string::npos) << result.err;
    EXPECT_TRUE(folder_.read("h.png").empty());
    EXPECT_EQ(run("m.scad -o m.png --imgsize=48,48 --time-limit 60").status, 0);
}

TEST_F(Cli, OptionsOfThePictureChangeIt) {
    ASSERT_EQ(run("m.scad -o a.png --imgsize=48,48").status, 0);
    for (const std::string options : {"--colorscheme Sunset", "--camera 0,0,0,0,0,0,60", "--projection o",
                                      "--transparent-background", "--samples 1", "-D '$vpd=200'"}) {
        ASSERT_EQ(run("m.scad -o b.png --imgsize=48,48 " + options).status, 0) << options;
        EXPECT_NE(folder_.read("a.png"), folder_.read("b.png")) << options;
    }
    const base::Image clear = [&] {
        EXPECT_EQ(run("m.scad -o c.png --imgsize=48,48 --transparent-background").status, 0);
        return base::read_png(folder_.path("c.png"));
    }();
    EXPECT_EQ(clear.pixel(0, 0)[3], 0);
    EXPECT_EQ(clear.pixel(24, 24)[3], 255);
}

/// As OpenSCAD: flat, unlit, between red lines of two pixels, framed by the outline itself.
TEST_F(Cli, RenderDrawsOutlinesFlat) {
    folder_.write("flat.scad", "square(10); translate([2, 2]) color(\"blue\") square(3); %square(40);\n");
    const std::string arguments =
        "flat.scad --imgsize=101,101 --camera=0,0,100,0,0,0,9 --viewall --autocenter "
        "--projection=o -o ";
    ASSERT_EQ(run(arguments + "r.png --render").status, 0);
    ASSERT_EQ(run(arguments + "p.png").status, 0);
    const base::Image image = base::read_png(folder_.path("r.png"));
    const auto color = [&](int x, int y) {
        const std::uint8_t* p = image.pixel(x, y);
        return p[0] << 16 | p[1] << 8 | p[2];
    };
    std::map<int, int> counts;
    for (int y = 0; y < 101; ++y) {
        for (int x = 0; x < 101; ++x) {
            ++counts[color(x, y)];
        }
    }
    EXPECT_EQ(counts.size(), 3U) << "background, face and line, without shades between";
    EXPECT_EQ(color(50, 50), 0x00bf99);
    // The circle about the square fills the picture: its side is 101 / sqrt(2) pixels.
    EXPECT_NEAR(counts[0x00bf99], 69.4 * 69.4, 80);
    EXPECT_NEAR(counts[0xff0000], 4 * 2 * 71.4, 80);
    EXPECT_NE(folder_.read("r.png"), folder_.read("p.png"));
}

/// Links that lead nowhere, and a folder that is within itself, so that a file has names without end.
TEST_F(Cli, LoopsOfLinksEnd) {
    fs::create_symlink("b.scad", folder_.path("a.scad"));
    fs::create_symlink("a.scad", folder_.path("b.scad"));
    fs::create_directory_symlink(".", folder_.path("self"));
    folder_.write("links.scad", "include <a.scad>\ncube(1);\n");
    folder_.write("include.scad", "include <self/include.scad>\ncube(1);\n");
    folder_.write("use.scad", "use <self/use.scad>\ncube(1);\n");
    for (const std::string name : {"links", "include", "use"}) {
        const Result result = run(name + ".scad -o " + name + ".csg");
        EXPECT_EQ(result.status, 0) << name << result.err;
        EXPECT_NE(result.err.find("Too many levels of symbolic links"), std::string::npos) << result.err;
        EXPECT_NE(result.err.find(name + ".scad, line 1"), std::string::npos) << result.err;
        EXPECT_NE(folder_.read(name + ".csg").find("cube("), std::string::npos);
    }
}

TEST_F(Cli, RenderShowsTheResultAlone) {
    folder_.write("parts.scad", "difference() { cube(10); #translate([5, -1, -1]) cube(12); } %sphere(20);\n");
    folder_.write("alone.scad", "cube([5, 10, 10]);\n");
    for (const std::string name : {"parts", "alone"}) {
        ASSERT_EQ(run(name + ".scad --render -o " + name + ".png --summary-file " + name + ".json").status, 0);
    }
    const auto box = nlohmann::json::parse(folder_.read("parts.json"))["bounding_box"];
    EXPECT_EQ(box["max"], nlohmann::json({5.0, 10.0, 10.0}));
    EXPECT_EQ(box["min"], nlohmann::json({0.0, 0.0, 0.0}));
    const base::Image a = base::read_png(folder_.path("parts.png")), b = base::read_png(folder_.path("alone.png"));
    const auto covered = [](const base::Image& image) {
        int count = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
            count += std::equal(image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                                image.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 3, image.rgba.begin())
                         ? 0
                         : 1;
        }
        return count;
    };
    EXPECT_GT(covered(a), 10000);
    EXPECT_EQ(covered(a), covered(b));
}

TEST_F(Cli, ReadsStandardInputAndWritesStandardOutput) {
    const Result result = run("- -o - --export-format png --imgsize 32,32", "cat m.scad |");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out.substr(1, 3), "PNG");
    ASSERT_EQ(run("m.scad -o m.png --imgsize 32,32").status, 0);
    EXPECT_EQ(result.out, folder_.read("m.png"));
}

TEST_F(Cli, DefinitionsOverrideTheFile) {
    folder_.write("e.scad", "a = 1;\nb = [0];\necho(a, b);\n");
    const Result result = run("e.scad -o - --export-format echo -D a=2 -D 'b=[1,2]' -q");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "ECHO: 2, [1, 2]\n");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(run("e.scad -o e.echo").err, "ECHO: 1, [0]\n");
}

TEST_F(Cli, WritesCsgAndSyntaxTree) {
    folder_.write("c.scad", "translate([1,2,3]) cube(4);\n");
    const Result result = run("c.scad -o c.csg -o c.ast");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(folder_.read("c.csg").find("cube(size = [4, 4, 4], center = false);"), std::string::npos);
    EXPECT_NE(folder_.read("c.ast").find("translate([1, 2, 3])"), std::string::npos);
}

TEST_F(Cli, WarningsAreOpenscadsAndMayBeHard) {
    folder_.write("w.scad", "cube(1);\ncube(unknown_thing);\n");
    const Result soft = run("w.scad -o w.csg");
    EXPECT_EQ(soft.status, 0);
    EXPECT_NE(soft.err.find("WARNING: Ignoring unknown variable"), std::string::npos) << soft.err;
    EXPECT_NE(soft.err.find("line 2"), std::string::npos) << soft.err;
    EXPECT_EQ(run("w.scad -o w.csg -q").err, "");
    folder_.remove("w.csg");
    EXPECT_EQ(run("w.scad -o w.csg --hardwarnings").status, 1);
    EXPECT_FALSE(fs::exists(folder_.path("w.csg")));
}

TEST_F(Cli, StatisticsAreComplete) {
    ASSERT_EQ(run("m.scad -o m.png --imgsize 32,32 --layers all --stats s.json").status, 0);
    const auto json = nlohmann::json::parse(folder_.read("s.json"));
    EXPECT_EQ(json.at("leaves"), 2);
    EXPECT_EQ(json.at("products"), 1);
    EXPECT_EQ(json.at("width"), 32);
    EXPECT_GE(json.at("layers").get<int>(), 2);
    for (const char* key :
         {"products_before_pruning", "passes", "fragments", "samples", "engine", "context", "renderer"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    for (const char* key : {"evaluate", "place", "normalize", "upload", "peel", "style", "read", "encode"}) {
        EXPECT_GE(json.at("ms").at(key).get<double>(), 0) << key;
    }
}

TEST_F(Cli, StatisticsSayWhatWasLeftOut) {
    folder_.write("far.scad", "cube(1); translate([1000, 0, 0]) cube(1); translate([0, 0, 1000]) cube(1e-6);");
    for (const std::string engine : {"lists-cpu", "lists"}) {
        ASSERT_EQ(
            run("far.scad -o f.png --imgsize 32,32 --samples 1 --camera=0,0,0,20,30,0,20 --stats s.json --engine " +
                engine)
                .status,
            0);
        const auto json = nlohmann::json::parse(folder_.read("s.json"));
        EXPECT_EQ(json.at("engine"), engine);
        EXPECT_EQ(json.at("drawn_leaves"), 1);
        EXPECT_EQ(json.at("skipped_leaves"), 2);
    }
}

TEST_F(Cli, StatisticsCountLeavesThatAreNotSeen) {
    // A ball within a block is never seen; the block behind is, with all layers.
    folder_.write("hidden.scad", "cube(10, center = true); sphere(2); translate([0, 0, -20]) cube(4, center = true);");
    const auto occluded = [&](const std::string& options) {
        EXPECT_EQ(
            run("hidden.scad -o h.png --imgsize 32,32 --samples 1 --camera=0,0,0,0,0,0,60 --stats s.json " + options)
                .status,
            0);
        return nlohmann::json::parse(folder_.read("s.json")).at("occluded_leaves");
    };
    EXPECT_EQ(occluded("--engine lists-cpu --layers 1"), 2);
    EXPECT_EQ(occluded("--engine lists-cpu --layers all"), 1);
    EXPECT_TRUE(occluded("--engine lists").is_null()) << "not known";
}

TEST_F(Cli, AnEngineThatCannotDrawIsReplacedAndItIsTold) {
    const Result result = run("m.scad -o m.png --imgsize 32,32 --engine scs --layers all --stats s.json");
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("scs finds one layer only"), std::string::npos) << result.err;
    const auto json = nlohmann::json::parse(folder_.read("s.json"));
    EXPECT_EQ(json.at("engine"), "lists-cpu");
    EXPECT_EQ(json.at("engine_reason"), "scs finds one layer only");
}

TEST_F(Cli, SummaryAndDependencies) {
    folder_.write("part.scad", "cube([1,2,3]);\n");
    folder_.write("main.scad", "include <part.scad>\n");
    ASSERT_EQ(run("main.scad -o main.csg -d main.d --summary-file s.json -D unused=1").status, 0);
    EXPECT_EQ(nlohmann::json::parse(folder_.read("s.json")).at("bounding_box").at("size"), nlohmann::json({1, 2, 3}));
    EXPECT_EQ(folder_.read("main.d"), "main.csg: \\\n\tmain.scad \\\n\tpart.scad\n");
}

TEST_F(Cli, AnEmptyModelIsABackground) {
    folder_.write("empty.scad", "");
    ASSERT_EQ(run("empty.scad -o e.png --imgsize 16,16").status, 0);
    const base::Image image = base::read_png(folder_.path("e.png"));
    EXPECT_EQ(std::vector<int>(image.pixel(8, 8), image.pixel(8, 8) + 3), (std::vector<int>{255, 255, 229}));
}

TEST_F(Cli, HelpVersionAndInformationEndWell) {
    EXPECT_NE(run("--help").out.find("--style"), std::string::npos);
    EXPECT_EQ(run("-h").status, 0);
    EXPECT_EQ(run("--version").out.substr(0, 9), "csgscope ");
    EXPECT_NE(run("--info").out.find("OpenGL"), std::string::npos);
}

TEST_F(Cli, WhatCannotBeDoneSaysSoAndLeavesNoFile) {
    fs::create_directory(folder_.path("dir"));
    unsetenv("DISPLAY");  // Where there is one, a window opens without any file.
    unsetenv("WAYLAND_DISPLAY");
    const std::pair<const char*, const char*> cases[] = {
        {"", "no input file"},
        {"missing.scad -o m.png", "missing.scad"},
        {"dir -o m.png", "dir"},
        {"m.scad -o nowhere/m.png", "nowhere/m.png"},
        {"m.scad -o m.step", "pdf, csg, ast, echo, term and param"},
        {"m.scad -o m.png --style bluprint", "Did you mean \"blueprint\"?"},
        {"m.scad -o m.png --set nonsense=1", "nonsense"},
        {"m.scad -o m.png --style blueprint --set width=thick", "thick"},
        {"m.scad -o m.png --colorscheme Cornfeld", "Did you mean \"Cornfield\"?"},
        {"m.scad -o m.png --context nvidia", "egl"},
        {"m.scad -o m.png --imgsize 99999,1", "1 to 16384"},
        {"m.scad -o m.png --camera 1,2", "6 numbers"},
        {"m.scad -o - --export-format png --stats -", "only one"},
        {"m.scad -o m.png -D 'x=('", "x=("},
    };
    for (const auto& [arguments, message] : cases) {
        SCOPED_TRACE(arguments);
        expect_error(run(arguments), message);
        EXPECT_FALSE(fs::exists(folder_.path("m.png")));
    }
}

/// Broken files: what is wrong, and where. The table is that of the parser's tests.
TEST_F(Cli, BrokenFilesAreLocatedErrors) {
    // What shows only when the program runs.
    const std::map<std::string, std::string> evaluation = {
        {"failed_assertion", "size must be positive"},
        {"endless_recursion", "Recursion detected calling function 'f'"},
        {"endless_module", "Recursion detected calling module 'm'"},
    };
    const fs::path bad = fs::path(CSGSCOPE_SOURCE_DIR) / "tests/ui/command_line/bad";
    std::ifstream table(fs::path(CSGSCOPE_SOURCE_DIR) / "tests/csg/scad/broken_files.txt");
    std::ptrdiff_t rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        ++rows;
        std::istringstream fields(line);
        std::string file, place, message;
        fields >> file >> place;
        std::getline(fields >> std::ws, message);
        SCOPED_TRACE(file);
        const auto late = evaluation.find(file);
        const Result result = run(fmt::format("'{}.scad' -o m.png", (bad / file).string()));
        expect_error(result, late == evaluation.end() ? "ERROR: " + message : late->second);
        EXPECT_NE(result.err.find(".scad" + place), std::string::npos) << result.err;
        EXPECT_NE(result.err.find('^'), std::string::npos) << "no caret in:\n" << result.err;
        EXPECT_FALSE(fs::exists(folder_.path("m.png")));
    }
    EXPECT_EQ(rows, std::distance(fs::directory_iterator(bad), fs::directory_iterator())) << "every file is tested";
}

/// Outputs for which nothing runs are refused as well.
TEST_F(Cli, ABrokenFileHasNoSyntaxTree) {
    folder_.write("broken.scad", "cube(\n");
    for (const char* const outputs : {"-o x.ast", "-o x.param", "-o x.ast -o x.param", "-o x.ast -o x.csg"}) {
        SCOPED_TRACE(outputs);
        const Result result = run(std::string("broken.scad ") + outputs);
        expect_error(result, "expected an expression");
        EXPECT_NE(result.err.find("broken.scad:2:1"), std::string::npos) << result.err;
        for (const char* const file : {"x.ast", "x.param", "x.csg"}) {
            EXPECT_FALSE(fs::exists(folder_.path(file))) << file;
        }
    }
}

TEST_F(Cli, TheLanguageNeedsNoGraphics) {
    fs::copy_file(CSGSCOPE_PROGRAM, folder_.path("alone"));
    for (const std::string format : {"csg", "ast", "echo", "param"}) {
        EXPECT_EQ(run_program("./alone", "m.scad -o m." + format).status, 0) << format;
        EXPECT_TRUE(fs::exists(folder_.path("m." + format))) << format;
    }
    const Result listed = run_program("/usr/bin/env", "LC_ALL=C ldd ./alone");
    const std::string loaded = listed.out + listed.err;
    EXPECT_TRUE(loaded.find("libc.so") != std::string::npos || loaded.find("not a dynamic") != std::string::npos)
        << loaded;
    for (const std::string library : {"EGL", "X11", "glfw", "freetype", "fmt"}) {
        EXPECT_EQ(loaded.find(library), std::string::npos) << loaded;
    }
    const Result picture = run_program("./alone", "m.scad -o m.png");
    EXPECT_EQ(picture.status, 1);
    EXPECT_NE(picture.err.find("cannot run"), std::string::npos) << picture.err;
    EXPECT_NE(picture.err.find("csgscope-graphics"), std::string::npos) << picture.err;
}

TEST_F(Cli, WhatIsHandedOverInTheMiddleIsSaidOnce) {
    folder_.write("metrics.scad",
                  "echo(\"before\"); if (is_undef(textmetrics(\"a\"))) cube(1); else cube(2); echo(\"after\");");
    const Result result = run("metrics.scad -o metrics.csg");
    ASSERT_EQ(result.status, 0) << result.err;
    for (const std::string line : {"ECHO: \"before\"", "ECHO: \"after\""}) {
        const std::size_t at = result.err.find(line);
        ASSERT_NE(at, std::string::npos) << result.err;
        EXPECT_EQ(result.err.find(line, at + 1), std::string::npos) << result.err;
    }
    EXPECT_NE(folder_.read("metrics.csg").find("cube("), std::string::npos);
}

}  // namespace
