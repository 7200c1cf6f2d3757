// csgscope measure, as its users run it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace {

using Json = nlohmann::json;

class Measure : public test_support::ProgramTest {
  protected:
    Measure() : ProgramTest(60) { folder_.write("plate.scad", kPlate); }

    static constexpr const char* kPlate =
        "difference() {\n"
        "  cube([40, 20, 10]);\n"
        "  for (i = [1:2]) translate([12 * i, 10, -1]) cylinder(d = 5, h = 12, $fn = 30);\n"
        "}\n"
        "translate([60, 0, 0]) scale([1, 2, 1]) cylinder(r = 5, h = 4);\n";
    /// From above: ten pixels for a millimeter about [20, 10].
    static constexpr const char* kAbove = "--projection o --camera=20,10,0,0,0,0,100.54679 --imgsize 400,400";

    [[nodiscard]] Json json(const std::string& options) const {
        const Result result = run(fmt::format("measure plate.scad {} --format json", options));
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(result.out);
    }
    [[nodiscard]] std::string value(const std::string& options) const {
        const Result result = run(fmt::format("measure plate.scad {}", options));
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    }
    void refuses(const std::string& options, const std::string& why) const {
        const Result result = run(fmt::format("measure plate.scad {}", options));
        EXPECT_EQ(result.status, 1) << options;
        EXPECT_EQ(result.out, "") << options;
        EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    }
};

TEST_F(Measure, TakesShapesByTheirCalls) {
    const Json bore = json("--of 3#1").at("of").at(0);
    EXPECT_EQ(bore.at("kind"), "cylinder");
    EXPECT_EQ(bore.at("radius"), 2.5);
    EXPECT_EQ(bore.at("diameter"), 5.0);
    EXPECT_EQ(bore.at("sides"), 30);
    EXPECT_EQ(bore.at("exact"), true);
    EXPECT_EQ(bore.at("call").at("line"), 3);
    EXPECT_EQ(value("--between 3#1 --and plate.scad:3#2 --value distance"), "12\n");
    EXPECT_EQ(value("--between +z@2 --and -z@2 --value distance"), "10\n");
    EXPECT_EQ(value("--between 3:47#1 --and -x@2:3 --value minimum"), "9.5\n");
    EXPECT_EQ(value("--between [43,4,5] --and +x@2 --between [0,0,0] --and [3,4,0] --value distance"), "3\n5\n");
    EXPECT_EQ(value("--between +x@2 --and 3#1 --value angle"), "0\n");
}

TEST_F(Measure, TakesFacesEdgesAndCornersByPixels) {
    const Json all =
        json(fmt::format("--of 20,200 --of edge@300,110 --of corner@390,290 --of edge@200,200 {}", kAbove)).at("of");
    EXPECT_EQ(all[0].at("kind"), "plane");
    EXPECT_EQ(all[0].at("normal"), Json({0.0, 0.0, 1.0}));
    EXPECT_EQ(all[1].at("kind"), "edge");
    EXPECT_NEAR(all[1].at("length").get<double>(), 40, 1e-9);
    EXPECT_EQ(all[2].at("kind"), "point");
    EXPECT_NEAR(all[2].at("at")[0].get<double>(), 40, 1e-9);
    EXPECT_NEAR(all[2].at("at")[1].get<double>(), 0, 1e-9);
    EXPECT_EQ(all[3].at("kind"), "circle");
    EXPECT_NEAR(all[3].at("radius").get<double>(), 2.5, 1e-9);
    EXPECT_EQ(value(fmt::format("--between 20,200 --and 20,200#2 --value distance {}", kAbove)), "10\n")
        << "the second surface there is the bottom";
}

TEST_F(Measure, TellsPeople) {
    const Result result = run("measure plate.scad --between 3#1 --and 3#2");
    EXPECT_EQ(result.status, 0);
    for (const char* text :
         {"between 3#1: cylinder, radius 2.5, diameter 5", "axis through [12, 10, 5] along [0, 0, 1]",
          "as written; its 30 sides come as near as 2.486305", "plate.scad:3:47", "distance 12\n",
          "between their surfaces 7 at least, 17 at most", "angle 0°, parallel"}) {
        EXPECT_NE(result.out.find(text), std::string::npos) << text << " is not in\n" << result.out;
    }
    EXPECT_EQ(run("measure plate.scad --between 3#1 --and 3#2").out, result.out);
}

TEST_F(Measure, SaysWhatIsWrong) {
    refuses("", "nothing to measure");
    refuses("--of there", "expected [x,y,z], a pixel X,Y");
    refuses("--of side@2", "expected [x,y,z]");
    refuses("--of 1,999", "from 0,0 to 511,511");
    refuses("--of 1,1", "there is nothing at that pixel");
    refuses("--of 20,200#3 " + std::string(kAbove), "there are 2 surfaces");
    refuses("--of 77", "nearest");
    refuses("--of 3", "2 shapes come from there: #1 to #2");
    refuses("--of 3#3", "2 shapes come from there");
    refuses("--of 2", "name a face of it by where it looks: +z@2");
    refuses("--of 5", "an ellipse of the half-axes 10 and 5 has no radius");
    refuses("--of +z@2 --value radius", "--value radius: there is none: plane");
    refuses("--between +z@2 --and +x@2 --value distance", "there is none");
    refuses("--between 2", "--between A goes with --and B");
    refuses("--of 3#1 --value girth", "radius");
    refuses("--of 3#1 -o x.png", "-o");
}

}  // namespace
