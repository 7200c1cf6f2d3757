// Outlines among solids and solids among outlines: the first child that makes anything decides. What is said, and how
// often, is what OpenSCAD of July 2026 says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/image.h"
#include "tests/support/program_test.h"

namespace {

class MixedDimensions : public test_support::ProgramTest {
  protected:
    MixedDimensions() : ProgramTest(60) {}

    std::string warnings(const std::string& said) {
        std::string lines;
        for (std::size_t at = said.find("WARNING: "); at != std::string::npos; at = said.find("WARNING: ", at + 1)) {
            const std::string line = said.substr(at + 9, said.find('\n', at) - at - 9);
            lines += line.substr(line.find("scad:") + 5) + "\n";
        }
        return lines;
    }
    /// Volume or area of the only file that can be written.
    void expect(const std::string& model, double measure, bool flat, const std::string& said) {
        SCOPED_TRACE(model);
        folder_.write("x.scad", model);
        const Result result =
            run(fmt::format("x.scad -o x.{} --summary geometry --summary area --summary volume --summary-file s.json",
                            flat ? "svg" : "off"));
        ASSERT_EQ(result.status, 0) << result.err;
        const auto geometry = nlohmann::json::parse(folder_.read("s.json")).at("geometry");
        EXPECT_NEAR(geometry.at(flat ? "area" : "volume").get<double>(), measure, 1e-9);
        EXPECT_EQ(warnings(result.err), said);
        EXPECT_EQ(run(fmt::format("x.scad -o y.{}", flat ? "off" : "svg")).status, 1);
    }
};

std::string mixing(int line) {
    return fmt::format("{}: Mixing 2D and 3D objects is not supported\n", line);
}
std::string no_flat(int line) {
    return fmt::format("{}: Ignoring 2D child object for 3D operation\n", line);
}
std::string no_solid(int line) {
    return fmt::format("{}: Ignoring 3D child object for 2D operation\n", line);
}

TEST_F(MixedDimensions, TheFirstChildDecides) {
    expect("cube(2);\ntranslate([9, 0]) square(3);\nsquare(1);", 8, false, mixing(2) + no_flat(2) + no_flat(3));
    expect("square(3);\ntranslate([9, 0]) cube(2);", 9, true, mixing(2) + no_solid(2));
    expect("group() { }\nunion() {\nsquare(3);\ncube(2); }\ncube(5);", 9, true,
           mixing(4) + no_solid(4) + mixing(5) + no_solid(5));
    expect("cube(2);\nunion() {\nsquare(3);\ncube(2); }", 8, false, mixing(4) + no_solid(4) + mixing(2) + no_flat(2));
    expect("translate([1, 1]) {\ncube(2);\nsquare(3); }\ncolor(\"red\") {\ncube(1);\nsquare(3); }", 9, false,
           mixing(3) + no_flat(3) + mixing(6) + no_flat(6));
    expect("cube(2);\n%square(3);", 8, false, "");
    expect("#square(2);\ncube(3);", 4, true, mixing(2) + no_solid(2));
}

TEST_F(MixedDimensions, BooleanOperands) {
    expect("difference() {\ncube(2);\nsquare(1);\ncube(1); }", 7, false, mixing(3) + no_flat(3));
    expect("difference() {\nsquare(2);\ncube(1);\nsquare(1); }", 3, true, mixing(3) + no_solid(3));
    folder_.write("x.scad", "intersection() {\ncube(2);\nsquare(3);\ncube(1); }");
    const Result empty = run("x.scad -o x.off");
    EXPECT_EQ(empty.status, 1);
    EXPECT_EQ(warnings(empty.err), mixing(3) + no_flat(3));
    EXPECT_NE(empty.err.find("empty"), std::string::npos) << empty.err;
    folder_.write("x.scad", "intersection() {\nsquare(2);\ncube(3); }");
    EXPECT_EQ(run("x.scad -o x.svg").status, 1);
}

TEST_F(MixedDimensions, OperandsOfWhatMakesMeshes) {
    expect("hull() {\ncube(2);\ntranslate([9, 0]) square(0);\ntranslate([9, 0]) square(3); }", 8, false,
           mixing(4) + no_flat(4));
    expect("hull() {\nsquare(2);\ncube(0);\ncube(3);\ncube(1); }", 4, true,
           mixing(4) + no_solid(3) + no_solid(4) + no_solid(5));
    expect("minkowski() {\ncube(2);\nsquare(3);\ncube(1); }", 27, false, mixing(3) + no_flat(3));
    expect("minkowski() {\nsquare(2);\ncube(3);\nsquare(1); }", 9, true, mixing(3) + no_solid(3));
    expect("render() {\ncube(2);\nsquare(3); }", 8, false, mixing(3) + no_flat(3));
    expect("resize([4, 2, 2]) {\ncube(2);\nsquare(9); }", 16, false, mixing(3) + no_flat(3));
    expect("projection() {\ncube(2);\nsquare(3);\nsquare(0); }", 4, true, no_flat(3) + no_flat(4));
    expect("linear_extrude(2) {\nsquare(2);\ncube(3);\ncube(0); }", 8, false, no_solid(3) + no_solid(4));
    expect("offset(delta = 1) {\ncube(3);\nsquare(2); }", 16, true, no_solid(2));
    folder_.write("x.scad", "minkowski() {\nsquare(2);\ncube(3); }");
    EXPECT_EQ(run("x.scad -o x.svg").status, 1) << "a sum with nothing, as in OpenSCAD";
}

/// A preview shows both; what is rendered is what an export would hold.
TEST_F(MixedDimensions, Pictures) {
    folder_.write("x.scad", "cube(2);\ntranslate([8, 0]) square(2);");
    const std::string picture = "--imgsize 64,32 --camera 5,1,0,0,0,0,40 --projection o --samples 1 ";
    const auto shows = [&](const std::string& arguments) {
        const Result result = run("x.scad -o x.png " + picture + arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        const base::Image image = base::read_png(folder_.path("x.png"));
        const auto differs = [&](int x) {
            return std::equal(image.pixel(x, 16), image.pixel(x, 16) + 3, image.pixel(0, 0)) ? 0 : 1;
        };
        int left = 0, right = 0;
        for (int x = 0; x < 32; ++x) {
            left += differs(x);
            right += differs(32 + x);
        }
        return std::pair(left > 0, right > 0);
    };
    EXPECT_EQ(shows(""), std::pair(true, true));
    EXPECT_EQ(shows("--render"), std::pair(true, false));
    EXPECT_EQ(shows("-o x.off"), std::pair(true, true)) << "beside an export";
}

}  // namespace
