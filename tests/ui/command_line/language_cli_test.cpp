// Options of the language, as users give them.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/program_test.h"
#include "tests/support/sanitizer.h"

namespace {

class LanguageCli : public test_support::ProgramTest {
  protected:
    LanguageCli() : ProgramTest(60) {}
    /// Standard error of a run that ends well.
    std::string messages_of(const std::string& arguments, const std::string& before = "") {
        const Result result = run(arguments + " -o o.csg", before);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.err;
    }
    /// The .csg text of a run that ends well.
    std::string text_of(const std::string& arguments) {
        messages_of(arguments);
        return folder_.read("o.csg");
    }
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(LanguageCli, MakesMissingFiles) {
    folder_.write("make.sh",
                  "echo \"$1 $2\" >> log; [ \"$2\" = wrong.dat ] && exit 3\n"
                  "case $2 in *.scad) echo 'function f() = 7;' > \"$2\";; *) echo '{\"a\": 5}' > \"$2\";; esac\n");
    folder_.write("part.scad", "echo(\"there\");\n");
    folder_.write("x.scad",
                  "include <part.scad>\nuse <it's made.scad>\necho(f());\n"
                  "for (i = [0:2]) echo(import(\"data.json\").a);\nsurface(\"wrong.dat\");\n");
    const std::string said = messages_of("x.scad -m 'sh make.sh with'");
    EXPECT_TRUE(contains(said, "ECHO: \"there\"\nECHO: 7\nECHO: 5\nECHO: 5\nECHO: 5\n")) << said;
    EXPECT_TRUE(contains(said, "-m: sh make.sh with 'wrong.dat' ended with status 3")) << said;
    EXPECT_EQ(folder_.read("log"), "with it's made.scad\nwith data.json\nwith wrong.dat\n") << "each once";
    EXPECT_TRUE(contains(messages_of("x.scad"), "ECHO: 7")) << "what was made stays";
}

TEST_F(LanguageCli, DependenciesNameDataFiles) {
    folder_.write("data.json", "1");
    folder_.write("x.scad", "echo(import(\"data.json\"));\nimport(\"mesh.stl\");\nassert(false);\n");
    EXPECT_EQ(run("x.scad -o x.csg -d x.d").status, 1);
    folder_.write("x.scad", "echo(import(\"data.json\"));\nimport(\"mesh.stl\");\n");
    ASSERT_EQ(run("x.scad -o x.csg -d x.d").status, 0);
    EXPECT_EQ(folder_.read("x.d"), "x.csg: \\\n\tx.scad \\\n\tdata.json \\\n\tmesh.stl\n");
}

TEST_F(LanguageCli, FontsAndDrawingsAreAsked) {
    folder_.write("a.dxf",
                  "0\nSECTION\n2\nENTITIES\n0\nDIMENSION\n8\n0\n1\nwidth\n70\n1\n13\n0\n23\n0\n14\n3\n24\n4\n"
                  "0\nLINE\n8\nc\n10\n0\n20\n0\n11\n2\n21\n2\n0\nLINE\n8\nc\n10\n0\n20\n2\n11\n2\n21\n0\n"
                  "0\nENDSEC\n0\nEOF\n");
    folder_.write("x.scad",
                  "echo(dxf_dim(file = \"a.dxf\", name = \"width\"), dxf_cross(\"a.dxf\", \"c\"));\n"
                  "echo(fontmetrics(\"Liberation Sans\").font.family, textmetrics(\"|\", size = 20).advance.x > 5);\n"
                  "echo(textmetrics(\"a\", size = 1 / 0).size);\n"
                  "echo(dxf_dim(\"a.dxf\", name = \"depth\"), dxf_cross(\"none.dxf\"));\n");
    const std::string language = messages_of("x.scad");
    EXPECT_TRUE(contains(language, "ECHO: 5, [1, 1]\n")) << language;
    EXPECT_TRUE(contains(language, "\", true\n")) << language;
    EXPECT_TRUE(
        contains(language, "WARNING: Can't find dimension 'depth' in 'a.dxf', layer ''! in file x.scad, line 4"))
        << language;
    EXPECT_TRUE(contains(language, "WARNING: Can't open DXF file 'none.dxf'! in file x.scad, line 4")) << language;
    // Where a picture is drawn the whole program evaluates: it says the same.
    const Result picture = run("x.scad -o x.png --imgsize 8,8");
    EXPECT_EQ(picture.status, 0);
    EXPECT_EQ(picture.err, language);
}

TEST_F(LanguageCli, FontFoldersComeFromTheEnvironment) {
    folder_.write("x.scad", "echo(fontmetrics(font = \"Liberation Mono\").font);\n");
    const auto known = messages_of("x.scad");
    const std::string family = "family = \"Liberation Mono\"";
    if (!contains(known, family)) {
        GTEST_SKIP() << "no Liberation fonts";
    }
    // A configuration without any folder, then the one that the environment adds.
    folder_.write("fonts.conf",
                  "<?xml version=\"1.0\"?><fontconfig><dir>" + folder_.path("none") + "</dir></fontconfig>");
    const std::string bare = "FONTCONFIG_FILE='" + folder_.path("fonts.conf") + "' ";
    EXPECT_FALSE(contains(messages_of("x.scad", bare), family));
    EXPECT_TRUE(contains(messages_of("x.scad", bare + "OPENSCAD_FONT_PATH=/none:/usr/share/fonts/truetype/liberation"),
                         family));
}

TEST_F(LanguageCli, TracesAreAsLongAsAskedFor) {
    folder_.write("x.scad", "module m(n) { if (n == 0) assert(false, \"end\"); else m(n - 1); }\nm(40);\n");
    const auto traces = [&](const std::string& arguments) {
        const Result result = run("x.scad -o x.csg " + arguments);
        EXPECT_EQ(result.status, 1);
        EXPECT_TRUE(contains(result.err, "Assertion 'false' failed: \"end\"")) << result.err;
        std::size_t count = 0;
        for (std::size_t at = 0; (at = result.err.find("TRACE: c", at)) != std::string::npos; ++at) {
            ++count;
        }
        return std::pair(count, contains(result.err, "m(n = 0)"));
    };
    EXPECT_EQ(traces(""), std::pair(std::size_t{24}, true));
    EXPECT_EQ(traces("--trace-depth 2"), std::pair(std::size_t{4}, true));
    EXPECT_EQ(traces("--trace-depth=0").first, 0U);
    EXPECT_FALSE(traces("--trace-usermodule-parameters=false").second);
}

TEST_F(LanguageCli, ChecksOfParameters) {
    folder_.write("x.scad", "cube(-1);\nfunction f(a) = a;\nx = f(1, 2);\nsphere(1, wrong = 2);\n");
    const std::string plain = messages_of("x.scad");
    EXPECT_FALSE(contains(plain, "cube(size")) << plain;
    EXPECT_TRUE(contains(plain, "Too many unnamed arguments")) << plain;
    EXPECT_TRUE(contains(messages_of("x.scad --check-parameter-ranges=on"), "WARNING: cube(size=-1"));
    const std::string unchecked = messages_of("x.scad --check-parameters=false");
    EXPECT_FALSE(contains(unchecked, "Too many unnamed arguments")) << unchecked;
    EXPECT_TRUE(contains(unchecked, "variable \"wrong\" not specified as parameter"))
        << "of built-in modules: " << unchecked;
    const Result bad = run("x.scad -o x.csg --check-parameters maybe");
    EXPECT_EQ(bad.status, 1);
    EXPECT_TRUE(contains(bad.err, "--check-parameters maybe")) << bad.err;
}

TEST_F(LanguageCli, ParameterSetsThenDefinitions) {
    folder_.write("x.scad", "width = 1;\ndepth = 2;\nname = \"a\";\necho(width, depth, name);\n");
    folder_.write("sets.json",
                  "{\"parameterSets\": {\"big\": {\"width\": \"10\", \"name\": \"b\"}}, \"fileFormatVersion\": \"1\"}");
    EXPECT_TRUE(contains(messages_of("x.scad -p sets.json -P big"), "ECHO: 10, 2, \"b\""));
    EXPECT_TRUE(
        contains(messages_of("x.scad -p sets.json -P big -D width=5 -D 'depth=[1,2]'"), "ECHO: 5, [1, 2], \"b\""));
    EXPECT_TRUE(contains(messages_of("x.scad -p sets.json"), "ECHO: 1, 2, \"a\""));
}

/// They are lines behind the file, as in the newest OpenSCAD.
TEST_F(LanguageCli, DefinitionsMayBeAnyStatements) {
    folder_.write("lib.scad", "b = 7; module lm() sphere(b); function lf() = 99; cylinder(1);\n");
    folder_.write("x.scad", "a = 1;\nfunction f(x) = x;\nmodule m() cube(a);\necho(a, f(2));\nm();");
    const auto text = [&](const std::string& arguments) {
        const std::string all = text_of("x.scad " + arguments);
        return all.substr(all.find("}\n") + 2);
    };
    const std::string sphere = "sphere($fn = 0, $fa = 12, $fs = 2, r = ";
    EXPECT_EQ(text("-D 'sphere(3);'"), sphere + "3);\n");
    EXPECT_EQ(text("-D 'sphere(3)'"), sphere + "3);\n");
    EXPECT_EQ(text("-D a=5 -D 'sphere(a)' -D a=7"), sphere + "7);\n") << "the last counts, everywhere";
    EXPECT_EQ(text("-D '%cube(a)'"), "%cube(size = [1, 1, 1], center = false);\n");
    EXPECT_EQ(text_of("x.scad -D 'module m() sphere(a);'"), "group() {\n\t" + sphere + "1);\n}\n");
    EXPECT_EQ(text_of("x.scad -D '!sphere(4)'"), sphere + "4);\n");
    EXPECT_EQ(text("-D 'include <lib.scad>' -D 'lm();'"),
              "cylinder($fn = 0, $fa = 12, $fs = 2, h = 1, r1 = 1, r2 = 1, center = false);\ngroup() {\n\t" + sphere +
                  "7);\n}\n");
    EXPECT_TRUE(contains(messages_of("x.scad -D 'function f(x) = 10 * x;'"), "ECHO: 1, 20"));
    EXPECT_TRUE(contains(messages_of("x.scad -D 'use <lib.scad>' -D 'echo(lf())'"), "ECHO: 1, 2\nECHO: 99\n"));
    EXPECT_TRUE(contains(messages_of("x.scad -D '{a=9;}'"), "ECHO: 9, 2"));
    EXPECT_TRUE(contains(messages_of("x.scad -D 'echo(none)'"), "unknown variable \"none\" in file x.scad, line 6"));
    folder_.write("sets.json", "{\"parameterSets\": {\"big\": {\"a\": \"10\"}}, \"fileFormatVersion\": \"1\"}");
    EXPECT_TRUE(contains(messages_of("x.scad -p sets.json -P big -D 'echo(a)'"), "ECHO: 10, 2\nECHO: 10\n"));
    EXPECT_TRUE(contains(messages_of("x.scad -p sets.json -P big -D 'echo(a)' -D a=3"), "ECHO: 3, 2\nECHO: 3\n"));
    const Result bad = run("x.scad -o x.csg -D 'foo bar'");
    EXPECT_EQ(bad.status, 1);
    EXPECT_TRUE(contains(bad.err, "x.scad")) << bad.err;
}

TEST_F(LanguageCli, FeaturesAreAlwaysOn) {
    folder_.write("x.scad", "echo(object(a = 1).a, [1, 2].yx);\nroof() square(1);\n");
    EXPECT_TRUE(contains(messages_of("x.scad"), "ECHO: 1, [2, 1]"));
    EXPECT_TRUE(contains(messages_of("x.scad --enable roof --enable=object-function"), "ECHO: 1, [2, 1]"));
}

TEST_F(LanguageCli, FeMeansSomethingWhereItIsEnabled) {
    folder_.write("x.scad", "circle(1, $fe = 0.01);\n");
    EXPECT_TRUE(contains(text_of("x.scad"), "circle($fn = 0, $fa = 12"));
    for (const char* const feature : {"discretization-by-error", "all"}) {
        EXPECT_TRUE(contains(text_of("x.scad --enable " + std::string(feature)), "circle($fn = 0, $fe = 0.01, $fa"));
    }
    folder_.write("x.scad", "$fe = -1;\ncircle(1);\n");
    EXPECT_TRUE(contains(messages_of("x.scad --enable all"), "$fe negative - setting to 0"));
}

TEST_F(LanguageCli, TooLittleMemoryIsSaid) {
    folder_.write(
        "x.scad",
        "function f(n) = n == 0 ? [] : concat([n], f(n - 1));\necho(len([for (i = [0:900000]) [i, i, i]]));\n");
    for (const char* limit : {"1", "2", "8", "16"}) {
        const Result result = run(std::string("x.scad -o x.csg --memory-limit ") + limit);
        EXPECT_EQ(result.status, 1) << limit << ": " << result.err;
        EXPECT_TRUE(contains(result.err, "emory") || contains(result.err, "Lists hold more than")) << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_.path("x.csg")));
    }
    EXPECT_EQ(run("x.scad -o x.csg --memory-limit 1000").status, test_support::kAddressSanitizer ? 1 : 0);
    const Result picture = run("m.scad -o x.png --memory-limit 1 --imgsize 12000,12000");
    EXPECT_EQ(picture.status, 1) << picture.err;
    EXPECT_TRUE(contains(picture.err, "--memory-limit")) << picture.err;
}

}  // namespace
