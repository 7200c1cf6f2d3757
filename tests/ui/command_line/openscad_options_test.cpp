// Options and formats that OpenSCAD has besides pictures and meshes of one moment.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/image.h"
#include "tests/support/program_test.h"

namespace {

namespace fs = std::filesystem;

class OpenScadOptions : public test_support::ProgramTest {
  protected:
    OpenScadOptions() : ProgramTest(60) {}
    void works(const std::string& arguments) {
        const Result result = run(arguments);
        EXPECT_EQ(result.status, 0) << arguments << result.err;
    }
    void fails(const std::string& arguments, const std::string& why) {
        const Result result = run(arguments);
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    }
    [[nodiscard]] bool exists(const std::string& name) const { return fs::exists(folder_.path(name)); }
};

TEST_F(OpenScadOptions, AnAnimationIsNumberedFiles) {
    folder_.write("x.scad", "echo(t = $t);\ncube(1 + 4 * $t);\nif ($t == 0.5) square(2);\n");
    works("x.scad -o x.csg -o x.stl --animate 4");
    EXPECT_NE(folder_.read("x00000.csg").find("size = [1, 1, 1]"), std::string::npos);
    EXPECT_NE(folder_.read("x00003.csg").find("size = [4, 4, 4]"), std::string::npos);
    EXPECT_NE(folder_.read("x00002.stl").find("vertex 3 3 3"), std::string::npos);
    EXPECT_FALSE(exists("x00004.csg") || exists("x.csg")) << "four of them, from 0 on";
    works("x.scad -o s.csg --animate 7 --animate_sharding 2/3");
    for (int frame = 0; frame < 7; ++frame) {
        EXPECT_EQ(exists("s0000" + std::to_string(frame) + ".csg"), frame >= 2 && frame < 4) << frame;
    }
    fails("x.scad --animate 3", "-o");
    fails("x.scad -o x.csg --animate 0", "--animate");
    fails("x.scad -o x.csg --animate_sharding 1/2", "--animate");
    fails("x.scad -o x.csg --animate 4 --animate_sharding 3/2", "--animate_sharding");
}

TEST_F(OpenScadOptions, PicturesOfAnAnimation) {
    folder_.write("x.scad", "translate([9 * $t, 0, 0]) cube(2);\n");
    works("x.scad -o f.png --animate 2 --imgsize 64,64 --camera 5,1,0,0,0,0,40 --samples 1");
    const auto lit = [&](const char* name) {
        const base::Image image = base::read_png(folder_.path(name));
        int left = 0, right = 0;
        for (int x = 0; x < 64; ++x) {
            const bool differs = !std::equal(image.pixel(x, 32), image.pixel(x, 32) + 3, image.pixel(0, 0));
            (x < 32 ? left : right) += differs ? 1 : 0;
        }
        return std::pair(left > 0, right > 0);
    };
    EXPECT_EQ(lit("f00000.png"), std::pair(true, false));
    EXPECT_TRUE(lit("f00001.png").second);
}

TEST_F(OpenScadOptions, ATurntableTurnsTheCamera) {
    const std::string size = " --imgsize 64,64 --samples 1 --style edges";
    works("m.scad -o t.png --turntable 4 --camera 0,0,0,55,0,25,60 --section quarter" + size);
    EXPECT_FALSE(exists("t00004.png"));
    works("m.scad -o one.png --camera 0,0,0,55,0,25,60 --section quarter" + size);
    EXPECT_EQ(folder_.read("t00000.png"), folder_.read("one.png"));
    works("m.scad -o plain.png --camera 0,0,0,55,0,115,60" + size);
    works("m.scad -o u.png --turntable 4 --camera 0,0,0,55,0,25,60" + size);
    EXPECT_EQ(folder_.read("u00001.png"), folder_.read("plain.png"));
    EXPECT_NE(folder_.read("t00002.png"), folder_.read("t00000.png")) << "the section stays where it is";
    works("m.scad -o s.png --turntable 4 --animate_sharding 2/2 --camera 0,0,0,55,0,25,60 --section quarter" + size);
    EXPECT_FALSE(exists("s00001.png"));
    EXPECT_EQ(folder_.read("s00003.png"), folder_.read("t00003.png"));
    fails("m.scad -o t.stl --turntable 4", "--turntable");
    fails("m.scad --turntable 4", "-o");
    fails("m.scad -o t.png --turntable 4 --animate 4", "--animate");
}

TEST_F(OpenScadOptions, ADistanceOfZeroIsForViewAll) {
    works("m.scad -o a.png --imgsize 64,64 --camera 0,0,0,55,0,25,0 --viewall");
    works("m.scad -o b.png --imgsize 64,64 --camera 0,0,0,55,0,25,140 --viewall");
    EXPECT_EQ(folder_.read("a.png"), folder_.read("b.png"));
    fails("m.scad -o c.png --camera 0,0,0,55,0,25,0", "--viewall");
}

TEST_F(OpenScadOptions, PythonIsDeclined) {
    folder_.write("m.py", "print(1)\n");
    fails("m.py -o x.png", "Python");
    fails("m.scad --trust-python -o x.png", "Python");
}

TEST_F(OpenScadOptions, LazyUnionLeavesOutGroups) {
    folder_.write("x.scad",
                  "module m() children();\nfor (i = [1, 2]) cube(i);\nif (true) { cube(3); cube(4); }\n"
                  "m() { cube(5); cube(6); }\n#for (i = [7]) cube(i);\n");
    const auto groups = [&](const std::string& arguments) {
        works("x.scad -o x.csg " + arguments);
        const std::string text = folder_.read("x.csg");
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find("group() {", at)) != std::string::npos; ++at) {
            ++count;
        }
        return count;
    };
    EXPECT_EQ(groups(""), 5U);
    EXPECT_EQ(groups("--enable=lazy-union"), 2U) << "the module's, and the one that is highlighted";
    EXPECT_EQ(groups("--enable all"), 2U);
}

TEST_F(OpenScadOptions, ViewsShowMarks) {
    folder_.write("x.scad", "cube(4, center = true);");
    const auto picture = [&](const std::string& view) {
        works("x.scad -o x.png --imgsize 200,200 --samples 1 --camera 0,0,0,90,0,0,40 " + view);
        return base::read_png(folder_.path("x.png"));
    };
    const auto is = [](const base::Image& image, int x, int y, int r, int g, int b) {
        const std::uint8_t* p = image.pixel(x, y);
        return p[0] == r && p[1] == g && p[2] == b;
    };
    const base::Image plain = picture(""), axes = picture("--view axes"), scales = picture("--view axes,scales"),
                      crosshairs = picture("--view crosshairs");
    EXPECT_TRUE(is(axes, 180, 99, 0, 0, 0) || is(axes, 180, 100, 0, 0, 0)) << "x, seen from the front";
    EXPECT_TRUE(std::equal(axes.pixel(100, 100), axes.pixel(100, 100) + 3, plain.pixel(100, 100))) << "hidden";
    int dashes = 0, changed = 0, ticks = 0, cross = 0;
    for (int x = 0; x < 60; ++x) {
        dashes += is(axes, x, 99, 0, 0, 0) || is(axes, x, 100, 0, 0, 0) ? 1 : 0;
    }
    EXPECT_GT(dashes, 20);
    EXPECT_LT(dashes, 40);
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x) {
            const bool same = std::equal(axes.pixel(x, y), axes.pixel(x, y) + 3, plain.pixel(x, y));
            changed += same ? 0 : 1;
            ticks += std::equal(axes.pixel(x, y), axes.pixel(x, y) + 3, scales.pixel(x, y)) ? 0 : 1;
            cross += is(crosshairs, x, y, 128, 0, 0) ? 1 : 0;
        }
    }
    EXPECT_GT(changed, 150);
    EXPECT_LT(changed, 500);
    EXPECT_GT(ticks, 50);
    EXPECT_GT(cross, 50);
    folder_.write("x.scad", "rotate(30) cube(4, center = true); translate([9, 0, 0]) sphere(1);");
    const base::Image without = picture(""), edges = picture("--view edges");
    int lighter = 0;
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x) {
            const std::uint8_t *p = without.pixel(x, y), *q = edges.pixel(x, y);
            lighter += p[2] != q[2] ? 1 : 0;
            ASSERT_TRUE(p[2] == q[2] || (!is(without, x, y, p[0], p[1], 229) && q[2] >= (p[2] + 255) / 2))
                << x << " " << y;
        }
    }
    EXPECT_GT(lighter, 60);
    EXPECT_LT(lighter, 600);
    fails("x.scad -o c.png --view axis", "axes");
}

/// Whatever begins with these is a file of OpenSCAD's to others.
TEST_F(OpenScadOptions, HeadersOfFiles) {
    folder_.write("flat.scad", "square(3);");
    works("m.scad -o x.stl -o x.obj -o x.pov -o x.term");
    works("m.scad -o b.stl --export-format binstl");
    works("flat.scad -o x.svg");
    EXPECT_TRUE(folder_.read("x.stl").starts_with("solid OpenSCAD_Model\n"));
    EXPECT_TRUE(folder_.read("x.stl").ends_with("endsolid OpenSCAD_Model\n"));
    EXPECT_TRUE(folder_.read("b.stl").starts_with("OpenSCAD Model\n"));
    EXPECT_TRUE(folder_.read("x.obj").starts_with("# OpenSCAD obj exporter\n"));
    EXPECT_TRUE(folder_.read("x.svg").starts_with("<?xml version=\"1.0\" standalone=\"no\"?>\n<!DOCTYPE svg "));
    EXPECT_NE(folder_.read("x.svg").find("<title>OpenSCAD Model</title>"), std::string::npos);
    EXPECT_EQ(folder_.read("x.term"), "No top-level CSG object\n");
}

TEST_F(OpenScadOptions, ScenesOfPovRay) {
    folder_.write("x.scad", "color(\"red\", 0.25) cube(2); translate([9, 0, 0]) cube(1);\n");
    works("x.scad -o x.pov --camera 1,2,3,0,0,0,50 --imgsize 200,100");
    const std::string text = folder_.read("x.pov");
    for (const char* part : {"#version 3.7;", "color srgbt <1, 0, 0, 0.75>", "location <1, 2, 53>", "look_at <1, 2, 3>",
                             "sky <0, 1, 0>", "right -x * 2", "light_source {"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
    std::size_t meshes = 0;
    for (std::size_t at = 0; (at = text.find("mesh2 {", at)) != std::string::npos; ++at) {
        ++meshes;
    }
    EXPECT_EQ(meshes, 2U) << "one for each color";
    EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
    works("x.scad -o o.pov --camera 1,2,3,0,0,0,50 --projection o");
    EXPECT_NE(folder_.read("o.pov").find("orthographic"), std::string::npos);
}

}  // namespace
