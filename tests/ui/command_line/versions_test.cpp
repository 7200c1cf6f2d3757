// Two versions of a model: what has changed, by part, as a picture, and in git.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/image.h"
#include "tests/support/program_test.h"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Versions : public test_support::ProgramTest {
  protected:
    Versions() : ProgramTest(60) {}
};

TEST_F(Versions, AreToldApart) {
    folder_.write("old.scad", "difference() { cube(10); %cube(20); translate([2, 2, -1]) cube([2, 2, 20]); }");
    folder_.write("new.scad", "difference() { cube([10, 10, 12]); translate([2, 2, -1]) cube([3, 2, 20]); }");
    const Result differ = run("compare old.scad new.scad --json");
    EXPECT_EQ(differ.status, 1) << differ.err;
    const Json json = Json::parse(differ.out);
    EXPECT_EQ(json.at("same"), false);
    EXPECT_NEAR(json.at("added").at("volume").get<double>(), 2 * (100 - 6), 1e-9);
    EXPECT_NEAR(json.at("removed").at("volume").get<double>(), 1 * 2 * 10, 1e-9);
    EXPECT_EQ(json.at("removed").at("box"), Json({{4.0, 2.0, 0.0}, {5.0, 4.0, 10.0}}));
    EXPECT_NE(run("compare old.scad new.scad").out.find("added    188, within [0, 0, 10]"), std::string::npos);

    // Another way to write the same solid.
    folder_.write("same.scad",
                  "union() { difference() { cube([5, 10, 10]); translate([2, 2, -1]) cube([2, 2, 20]); }"
                  " translate([5, 0, 0]) cube([5, 10, 10]); }");
    const Result same = run("compare old.scad same.scad");
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    EXPECT_NE(same.out.find("are the same solid"), std::string::npos);
    EXPECT_EQ(run("compare old.scad missing.scad").status, 1);
}

TEST_F(Versions, AreToldApartPartByPart) {
    const std::string modules = "module plate(h) cube([20, 10, h]); module peg() cylinder(r = 2, h = 5, $fn = 4);\n";
    folder_.write("old.scad", modules +
                                  "difference() { plate(3); translate([5, 5, -1]) peg(); }\n"
                                  "translate([0, 20, 0]) peg(); translate([9, 20, 0]) peg(); cube(1);");
    folder_.write("new.scad", modules +
                                  "difference() { plate(4); translate([5, 5, -1]) peg(); }\n"
                                  "translate([9, 20, 0]) peg(); translate([30, 0, 0]) plate(1);");
    const Result differ = run("compare old.scad new.scad --json");
    EXPECT_EQ(differ.status, 1) << differ.err;
    std::vector<std::string> found;
    const Json json = Json::parse(differ.out);
    for (const Json& part : json.at("parts")) {
        found.push_back(fmt::format("{}{}: {} +{:.6g} -{:.6g}", part.at("part").get<std::string>(),
                                    part.at("was").is_null() ? "" : " was " + part.at("was").get<std::string>(),
                                    part.at("change").get<std::string>(), part.at("added").at("volume").get<double>(),
                                    part.at("removed").at("volume").get<double>()));
    }
    EXPECT_EQ(found, (std::vector<std::string>{"plate: changed +192 -0", "peg was peg 2: unchanged +0 -0",
                                               "plate 2: new +200 -0", "peg: gone +0 -40", "part 4: gone +0 -1"}));
    const Result table = run("compare old.scad new.scad");
    EXPECT_NE(table.out.find("\npeg (was peg 2)  unchanged      -        -\n"), std::string::npos) << table.out;
    const Result colors = run("compare old.scad new.scad --parts color");
    EXPECT_EQ(colors.out.find("unchanged"), std::string::npos) << "one part: no table\n" << colors.out;
    EXPECT_NE(run("compare old.scad --parts top").err.find("--parts divides versions"), std::string::npos);
    EXPECT_NE(run("compare old.scad new.scad --parts topp").err.find("top"), std::string::npos);
}

/// The setup of the page, line by line, in a repository.
TEST_F(Versions, GitShowsWhatHasChanged) {
    if (std::system("git --version > /dev/null 2>&1") != 0) {
        GTEST_SKIP() << "there is no git";
    }
    const std::string page = test_support::read_file(CSGSCOPE_SOURCE_DIR "/docs/inside/CHANGES.md");
    const std::size_t begin = page.find("    echo '*.scad diff=csgscope'"), end = page.find("\n\n", begin);
    ASSERT_NE(begin, std::string::npos);
    folder_.write("setup.sh",
                  "set -e; cd repository; git init -q .; git config user.email a@b.c; git config user.name a\n"
                  "mkdir parts; echo 'module lid() cube([4, 3, 2]);' > parts/lib.scad\n"
                  "echo 'use <parts/lib.scad>\nlid();' > box.scad\n"
                  "git add -A; git commit -qm 1\n" +
                      page.substr(begin, end - begin) +
                      "\nsed -i 's/^lid/translate([1, 0, 0]) lid/' box.scad; echo 'cube(1);' > new.scad\n"
                      "git add -A; git --no-pager diff --cached\n");
    fs::create_directory(folder_.path("repository"));
    const fs::path program = CSGSCOPE_PROGRAM;
    const std::string command = fmt::format("cd '{}' && PATH=\"{}:$PATH\" sh setup.sh > shown 2>&1", folder_.path(""),
                                            program.parent_path().string());
    ASSERT_EQ(std::system(command.c_str()), 0) << folder_.read("shown");
    const std::string shown = folder_.read("shown");
    EXPECT_NE(shown.find("added    6, within [4, 0, 0] and [5, 3, 2]"), std::string::npos) << shown;
    EXPECT_NE(shown.find("removed  6, within [0, 0, 0] and [1, 3, 2]"), std::string::npos) << shown;
    EXPECT_NE(shown.find("/dev/null and "), std::string::npos) << shown;
    EXPECT_NE(shown.find("added    1, within [0, 0, 0] and [1, 1, 1]"), std::string::npos) << shown;
}

TEST_F(Versions, ChangesAreDrawn) {
    folder_.write("old.scad", "cube(10); translate([30, 0, 0]) color(\"blue\") cube(10);");
    folder_.write("new.scad", "cube(10); translate([15, 0, 0]) color(\"blue\") cube(10);");
    ASSERT_EQ(
        run("new.scad --changes-from old.scad -o c.png --imgsize 200,100 --samples 1 --viewall --autocenter").status,
        0);
    const base::Image image = base::read_png(folder_.path("c.png"));
    int green = 0, red = 0, blue = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const int r = image.rgba[i], g = image.rgba[i + 1], b = image.rgba[i + 2];
        green += g > 2 * r ? 1 : 0;
        red += r > 2 * g ? 1 : 0;
        blue += b > 2 * r && b > 2 * g ? 1 : 0;
    }
    EXPECT_GT(green, 300) << "what is new";
    EXPECT_GT(red, 300) << "what is gone";
    EXPECT_EQ(blue, 0) << "whatever color it has";
    EXPECT_EQ(run("new.scad --changes-from missing.scad -o c.png").status, 1);
    folder_.write("broken.scad", "cube(");
    EXPECT_NE(run("new.scad --changes-from broken.scad -o c.png").err.find("broken.scad:1:6"), std::string::npos);
    EXPECT_NE(run("new.scad --changes-from old.scad -o c.stl").err.find("csgscope compare"), std::string::npos);
}

}  // namespace
