// An object that cannot be made fails what is exported; a picture shows the rest.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/program_test.h"
#include "tests/support/sanitizer.h"

namespace {

class FailingObjects : public test_support::ProgramTest {
  protected:
    FailingObjects() : ProgramTest(60) {}

    /// Nothing is written, all of `said` is.
    void expect_no_export(const std::string& model, const std::string& output, const std::vector<std::string>& said) {
        folder_.write("x.scad", model);
        const Result result = run("x.scad -o " + output);
        EXPECT_EQ(result.status, 1) << model << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_.path(output))) << model;
        for (const std::string& text : said) {
            EXPECT_NE(result.err.find(text), std::string::npos) << model << "expected " << text << " in " << result.err;
        }
    }
};

/// Deeper than differences may nest that are needed as a mesh.
std::string too_deep(const std::string& other) {
    return "module d(n) { if (n == 0) cube(1); else difference() { d(n - 1); translate([2, 0, 0]) cube(n); } }\n"
           "resize([3, 3, 3]) d(600);\n" +
           other;
}

TEST_F(FailingObjects, AreAllListedWithTheirPlaces) {
    expect_no_export("cube(1);\nimport(\"none.stl\");\nsphere(3, $fn = 1e9);\n", "x.stl",
                     {"x.scad:2: Can't open import file", "x.scad:3: this object is left out: it needs 1000000000"});
}

TEST_F(FailingObjects, FailAsCuttersToo) {
    expect_no_export("difference() {\n  cube(3);\n  import(\"none.stl\");\n}\n", "x.stl", {"x.scad:3: "});
    expect_no_export("difference() {\n  square(3);\n  import(\"none.svg\");\n}\n", "x.svg", {"x.scad:3: "});
    expect_no_export(too_deep("cube(1);\n"), "x.off", {"x.scad:2: this object is left out: differences"});
}

TEST_F(FailingObjects, LessThanWasAskedForIsAFailure) {
    // Half a file, slices that are not made.
    folder_.write("half.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n");
    expect_no_export("cube(1);\nimport(\"half.off\");\n", "x.stl", {"x.scad:2: OFF file ends early"});
    expect_no_export("linear_extrude(2, twist = 9, slices = 1e9) square(2);\n", "x.stl",
                     {"x.scad:1: this object is left out: linear_extrude() has too many slices"});
    folder_.write("torn.svg", "<svg><rect width='5' height='5'/><g>");
    expect_no_export("import(\"torn.svg\");\n", "x.dxf", {"x.scad:1: XML error"});
    folder_.write("nan.stl", "solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0 nan\nvertex 1 0 0\nvertex 0 1 0\n");
    expect_no_export("cube(1);\nimport(\"nan.stl\");\n", "x.stl", {"no finite number"});
}

TEST_F(FailingObjects, CoordinatesBeyondDoublesSaySo) {
    expect_no_export("cube(1);\ncube(1e300);\n", "x.stl", {"x.scad:2: this object is left out: its coordinates reach"});
    expect_no_export("cube(1);\nscale(1e200) scale(1e200) cube(1);\n", "x.stl", {"x.scad:2: ", "not finite"});
    // What doubles can tell apart has a mesh; that no picture shows it is a warning.
    folder_.write("x.scad", "translate([1e15, 1e15, 1e15]) cube(1);\ncube(1);\n");
    const auto far = run("x.scad -o x.stl");
    EXPECT_EQ(far.status, 0);
    EXPECT_NE(far.err.find("x.scad:2: no picture shows this object"), std::string::npos) << far.err;
    std::filesystem::remove(folder_.path("x.stl"));
    expect_no_export("translate([1e19, 0, 0]) cube(1);\n", "x.stl", {"x.scad:1: ", "too thin"});
    // As a cutter for all that there is, anything goes.
    folder_.write("x.scad", "intersection() { cube(2); translate([1, 0, 0]) cube(1e20); }\n");
    EXPECT_EQ(run("x.scad -o x.stl").status, 0);
}

TEST_F(FailingObjects, APictureShowsTheRestWithAWarning) {
    folder_.write("x.scad", "cube(1);\nimport(\"none.stl\");\n");
    const Result picture = run("x.scad -o x.png --imgsize 40,40");
    EXPECT_EQ(picture.status, 0) << picture.err;
    EXPECT_NE(picture.err.find("WARNING: x.scad:2: Can't open import file"), std::string::npos) << picture.err;
    EXPECT_TRUE(std::filesystem::exists(folder_.path("x.png")));
    EXPECT_EQ(run("x.scad -o hard.png --imgsize 40,40 --hardwarnings").status, 1);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("hard.png")));
    // Together with an export neither is written.
    EXPECT_EQ(run("x.scad -o both.png -o both.stl --imgsize 40,40").status, 1);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("both.png")));
    EXPECT_EQ(run("compare x.scad").status, 1);
}

TEST_F(FailingObjects, OutOfMemoryIsNeverAWarning) {
    folder_.write("x.scad", "cube(1);\nminkowski() { sphere(10, $fn = 300); sphere(1, $fn = 300); }\n");
    const Result result = run("x.scad -o x.stl --memory-limit 150");
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.err.find(test_support::kAddressSanitizer ? "csgscope: error: --memory-limit: the evaluation needs"
                                                              : "csgscope: error: out of memory for "),
              std::string::npos)
        << result.err;
    EXPECT_EQ(result.err.find("WARNING"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("x.stl")));
}

TEST_F(FailingObjects, FinenessThatIsNoNumberIsIgnored) {
    // As the newest OpenSCAD: corners of circle(3, …).
    for (const auto& [fineness, corners] :
         std::initializer_list<std::pair<const char*, int>>{{"$fa = 0 / 0", 10},
                                                            {"$fs = 0 / 0", 30},
                                                            {"$fn = 0 / 0", 3},
                                                            {"$fn = 1 / 0", 3},
                                                            {"$fa = 1 / 0", 5},
                                                            {"$fs = 1 / 0", 5},
                                                            {"$fa = 0 / 0, $fs = 0 / 0", 5}}) {
        folder_.write("x.scad", std::string("circle(3, ") + fineness + ");\n");
        const Result result = run("x.scad -o x.dxf");
        EXPECT_EQ(result.status, 0) << fineness << result.err;
        int found = 0;
        const std::string text = folder_.read("x.dxf");
        for (std::size_t at = text.find("\nLINE\n"); at != std::string::npos; at = text.find("\nLINE\n", at + 1)) {
            ++found;
        }
        EXPECT_EQ(found, corners) << fineness;
        for (const char* const solid : {"sphere(3, ", "cylinder(3, 3, 3, ", "linear_extrude(3, twist = 90, ",
                                        "rotate_extrude(", "linear_extrude(3, scale = [1, 2], "}) {
            folder_.write("x.scad", std::string(solid) + fineness + ") translate([3, 0]) square(1);\n");
            EXPECT_EQ(run("x.scad -o x.stl").status, 0) << solid << fineness;
        }
    }
}

}  // namespace
