// csgscope move as its users run it. The ways themselves: tests/ui/pipeline/move_leaf_test.
#include <gtest/gtest.h>

#include "tests/support/program_test.h"
#include "tests/support/refusals.h"

namespace {

class MoveProgram : public test_support::ProgramTest {
  protected:
    MoveProgram() : ProgramTest(60) { folder_.write("box.scad", kText); }
    static constexpr const char* kText =
        "wall = 2;  // of all sides\n"
        "module lid() translate([0, 0, 20 + wall]) cube([40, 30, wall]);\n"
        "translate([60, 0, 0]) lid();\n"
        "for (x = [5, 35]) translate([x, 5, 0]) cylinder(r = 2, h = 30);\n";
};

TEST_F(MoveProgram, TellsTheWays) {
    const Result result = run("move box.scad --call 3 --by 0,5,0");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("  1.  change translate() (box.scad:3:1): moves 1 thing\n      0 -> 5\n"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("put a translate() before lid()"), std::string::npos) << result.out;
    const Result loop = run("move box.scad --call 4 --number 2 --by 3,0,0");
    EXPECT_NE(loop.out.find("change for() (box.scad:4:1): moves 1 thing\n      35 -> 38"), std::string::npos)
        << loop.out;
}

TEST_F(MoveProgram, WritesTheText) {
    EXPECT_EQ(run("move box.scad --call 3 --by 0,5,0 -o box.scad").status, 0);
    std::string expected = kText;
    expected.replace(expected.find("[60, 0, 0]"), 10, "[60, 5, 0]");
    EXPECT_EQ(folder_.read("box.scad"), expected);
    EXPECT_EQ(run("move box.scad --call 3 --by 0,-5,0 -o back.scad").status, 0);
    EXPECT_EQ(folder_.read("back.scad"), kText);
    const Result second = run("move box.scad --call 3 --by 0,5,0 --choice 2 -o -");
    EXPECT_EQ(second.status, 0);
    EXPECT_NE(second.out, folder_.read("box.scad"));
    // Definitions count, and stay out of the text.
    for (const char* const definition : {"-D 'wall=3'", "-D 'sphere(1);'"}) {
        const Result defined = run(std::string("move back.scad --call 3 --by 0,5,0 -o - ") + definition);
        EXPECT_EQ(defined.status, 0) << defined.err;
        EXPECT_EQ(defined.out, folder_.read("box.scad"));
    }
}

TEST_F(MoveProgram, TurnsAndStretches) {
    folder_.write("part.scad", "translate([5, 0, 0]) cube([10, 4, 2]);\nrotate([0, 0, 15]) cylinder(h = 8, r = 2);\n");
    EXPECT_EQ(
        run("move part.scad --call 1 --turn 0,0,30 -o -").out,
        "translate([5, 0, 0]) rotate([0, 0, 30]) cube([10, 4, 2]);\nrotate([0, 0, 15]) cylinder(h = 8, r = 2);\n");
    EXPECT_EQ(run("move part.scad --call 2 --turn 0,0,30 -o -").out,
              "translate([5, 0, 0]) cube([10, 4, 2]);\nrotate([0, 0, 45]) cylinder(h = 8, r = 2);\n");
    EXPECT_EQ(run("move part.scad --call 1 --stretch +x,2.5 -o -").out,
              "translate([5, 0, 0]) cube([12.5, 4, 2]);\nrotate([0, 0, 15]) cylinder(h = 8, r = 2);\n");
    EXPECT_EQ(run("move part.scad --call 2 --stretch +z,-3 -o -").out,
              "translate([5, 0, 0]) cube([10, 4, 2]);\nrotate([0, 0, 15]) cylinder(h = 5, r = 2);\n");
    EXPECT_EQ(run("move part.scad --call 1 --scale 2 -o -").out,
              "translate([5, 0, 0]) cube([20, 8, 4]);\nrotate([0, 0, 15]) cylinder(h = 8, r = 2);\n");
    const Result below = run("move part.scad --call 1 --stretch -x,1");
    EXPECT_EQ(below.status, 1);
    EXPECT_NE(below.err.find("no number of it moves that side"), std::string::npos) << below.err;
}

TEST_F(MoveProgram, TellsHowManyCanBeMoved) {
    const Result all = run("move box.scad --survey 9");
    EXPECT_EQ(all.status, 0) << all.err;
    EXPECT_EQ(all.out,
              "     1  change translate() (box.scad:2:14): moves 1\n"
              "     2  change for() and translate() (box.scad:4:1): moves 2\n"
              "     3  change for() and translate() (box.scad:4:1): moves 2\n"
              "3 of 3 solids (3 in all) can be moved: 3 by numbers of a call, 0 of a variable, 0 by a translate()\n");
    folder_.write("shapes.scad", "sphere(1); module two() { cube(1); translate([3, 0, 0]) cube(1); }");
    folder_.write("uses.scad",
                  "include <shapes.scad>\n"
                  "two();\n"
                  "translate(rands(0, 9, 3)) cube(1);\n");
    const Result some = run("move uses.scad --survey 9");
    EXPECT_EQ(some.status, 0) << some.err;
    EXPECT_EQ(some.out,
              "     1  not moved: no call of this file leads to it\n"
              "     2  put a translate() before two() (uses.scad:2:1): moves 2\n"
              "     3  put a translate() before two() (uses.scad:2:1): moves 2\n"
              "     4  put a translate() before cube() (uses.scad:3:27): moves 1\n"
              "3 of 4 solids (4 in all) can be moved: 0 by numbers of a call, 0 of a variable, 3 by a translate()\n");
    EXPECT_NE(run("move uses.scad --survey 2").out.find("of 2 solids (4 in all)"), std::string::npos);
}

TEST_F(MoveProgram, RefusesWhatItCannotDo) {
    test_support::expect_refused([this](const std::string& arguments) { return run(arguments); },
                                 {{"move box.scad --call 3 --by 0,0,0", "moves nothing"},
                                  {"move box.scad --call 9 --by 1,0,0", "nearest"},
                                  {"move box.scad --call 4 --number 3 --by 1,0,0", "2 solids come"},
                                  {"move box.scad --call 3 --by 1,0,0 --choice 99", "there are"},
                                  {"move box.scad --call 3 --by 1,0", "x,y,z"},
                                  {"move box.scad --cal 3 --by 1,0,0", "--call"},
                                  {"move box.scad --by 1,0,0", "--survey"},
                                  {"move box.scad --call 3 --by 1,0,0 --turn 0,0,1", "one of --by"},
                                  {"move box.scad --call 3", "one of --by"},
                                  {"move box.scad --call 3 --turn 0,0,180", "half a turn"},
                                  {"move box.scad --call 3 --turn 0,0,0", "turns nothing"},
                                  {"move box.scad --call 3 --scale 1,1,0", "factors above 0"},
                                  {"move box.scad --call 3 --scale 1", "scales nothing"},
                                  {"move box.scad --call 3 --stretch x,2", "a side and how far"},
                                  {"move box.scad --call 3 --stretch +x,0", "stretches nothing"},
                                  {"move box.scad --survey 3 --turn 0,0,1", "with --by"},
                                  {"move box.scad --survey 3 --call 3", "without --call"},
                                  {"move box.scad --survey 0", "--survey"},
                                  {"move none.scad --call 3 --by 1,0,0", "none.scad"}});
    EXPECT_EQ(folder_.read("box.scad"), kText);
}

}  // namespace
