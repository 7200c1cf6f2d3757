// csgscope pick, as its users run it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace {

using Json = nlohmann::json;

class Pick : public test_support::ProgramTest {
  protected:
    Pick() : ProgramTest(60) {}

    /// A look straight down onto the point (x, y), which is in pixel 5,5 of 11 × 11.
    [[nodiscard]] Result look(const std::string& file, double x, double y, const std::string& more = "") const {
        return run(fmt::format("pick {} --at 5,5 --imgsize 11,11 --camera={},{},0,0,0,0,100 {}", file, x, y, more));
    }
    [[nodiscard]] Json surfaces(const std::string& file, double x, double y, const std::string& more = "") const {
        const Result result = look(file, x, y, more + " --format json");
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(result.out).at("surfaces");
    }
    /// "name@file:line:column"
    static std::vector<std::string> calls(const Json& surface) {
        std::vector<std::string> calls;
        for (const Json& call : surface.at("calls")) {
            calls.push_back(fmt::format("{}@{}:{}:{}", call.at("name").get<std::string>(),
                                        call.at("file").get<std::string>(), call.at("line").get<int>(),
                                        call.at("column").get<int>()));
        }
        return calls;
    }
};

using Calls = std::vector<std::string>;

constexpr const char* kPlate =
    "use <lib.scad>\n"
    "module hole(d) {\n"
    "  translate([0, 0, 2]) cylinder(d = d, h = 12);\n"
    "}\n"
    "module plate() difference() {\n"
    "  color(\"#ff8000\") cube([40, 20, 10]);\n"
    "  for (i = [1:3]) translate([10 * i, 10, 0]) hole(d = 5);\n"
    "}\n"
    "plate();\n"
    "knob(2);\n";
constexpr const char* kLib = "module knob(r) translate([60, 0, 0]) { cube(2 * r, center = true); }\n";

TEST_F(Pick, TellsEverySurfaceBehindAPixel) {
    folder_.write("plate.scad", kPlate);
    folder_.write("lib.scad", kLib);
    const Json s = surfaces("plate.scad", 3, 3);
    ASSERT_EQ(s.size(), 2u);
    EXPECT_NEAR(s[0].at("distance").get<double>(), 90, 1e-6);
    EXPECT_NEAR(s[1].at("distance").get<double>(), 100, 1e-6);
    EXPECT_NEAR(s[0].at("point")[0].get<double>(), 3, 1e-6);
    EXPECT_NEAR(s[0].at("point")[1].get<double>(), 3, 1e-6);
    EXPECT_NEAR(s[0].at("point")[2].get<double>(), 10, 1e-6);
    EXPECT_NEAR(s[0].at("normal")[2].get<double>(), 1, 1e-9);
    EXPECT_NEAR(s[1].at("normal")[2].get<double>(), -1, 1e-9);
    EXPECT_EQ(s[0].at("layer"), 1);
    EXPECT_EQ(s[0].at("shape"), "cube");
    EXPECT_EQ(s[0].at("operation"), "adds");
    EXPECT_EQ(s[0].at("color"), "#ff8000");
    EXPECT_EQ(s[0].at("part").at("name"), "model");
    EXPECT_EQ(s[0].at("in_front"), Json::array());
    EXPECT_EQ(s[0].at("behind"), Json({"model"}));
    EXPECT_EQ(calls(s[0]), (Calls{"plate@plate.scad:9:1", "difference@plate.scad:5:16", "color@plate.scad:6:3",
                                  "cube@plate.scad:6:20"}));
    for (const Json& call : s[0].at("calls")) {
        EXPECT_EQ(call.at("module"), call.at("name") == "plate");
    }
}

TEST_F(Pick, NamesACutAfterTheCutter) {
    folder_.write("plate.scad", kPlate);
    folder_.write("lib.scad", kLib);
    const Json s = surfaces("plate.scad", 20, 10);
    ASSERT_EQ(s.size(), 2u);
    EXPECT_NEAR(s[0].at("point")[2].get<double>(), 2, 1e-6) << "the bottom of the hole";
    EXPECT_EQ(s[0].at("shape"), "cylinder");
    EXPECT_EQ(s[0].at("operation"), "subtracts");
    EXPECT_EQ(s[0].at("color"), nullptr);
    EXPECT_EQ(s[0].at("behind"), Json({"model"}));
    EXPECT_EQ(calls(s[0]), (Calls{"plate@plate.scad:9:1", "difference@plate.scad:5:16", "for@plate.scad:7:3",
                                  "translate@plate.scad:7:19", "hole@plate.scad:7:46", "translate@plate.scad:3:3",
                                  "cylinder@plate.scad:3:24"}));
    const Json& round = s[0].at("calls")[3];
    EXPECT_EQ(round.at("child"), 1) << "the second time round";
    EXPECT_EQ(round.at("of"), 3);
    const auto text = [&](const Json& call) {
        return std::string(kPlate).substr(call.at("begin"),
                                          call.at("end").get<std::size_t>() - call.at("begin").get<std::size_t>());
    };
    EXPECT_EQ(text(round), "translate([10 * i, 10, 0])");
    EXPECT_EQ(text(s[0].at("calls")[4]), "hole(d = 5)");
}

TEST_F(Pick, CountsTheBytesOfTheFile) {
    const std::string text = "\xEF\xBB\xBFunion() cube(9);";
    folder_.write("mark.scad", text);
    const Json s = surfaces("mark.scad", 3, 3);
    ASSERT_EQ(s.size(), 2u);
    const Json& cube = s[0].at("calls")[1];
    const auto begin = cube.at("begin").get<std::size_t>();
    EXPECT_EQ(begin, 11u) << "the byte order mark's three are of the file";
    EXPECT_EQ(text.substr(begin, cube.at("end").get<std::size_t>() - begin), "cube(9)");
}

TEST_F(Pick, FollowsFilesThatAreUsed) {
    folder_.write("plate.scad", kPlate);
    folder_.write("lib.scad", kLib);
    const Json s = surfaces("plate.scad", 60, 0);
    ASSERT_EQ(s.size(), 2u);
    EXPECT_EQ(calls(s[0]), (Calls{"knob@plate.scad:10:1", "translate@lib.scad:1:16", "cube@lib.scad:1:40"}));
}

TEST_F(Pick, IsTheSameByEveryEngine) {
    folder_.write("plate.scad", kPlate);
    folder_.write("lib.scad", kLib);
    const std::string one = look("plate.scad", 20, 10, "--engine lists-cpu").out;
    EXPECT_NE(one.find("cut by cylinder"), std::string::npos) << one;
    for (const char* engine : {"goldfeather", "lists"}) {
        EXPECT_EQ(look("plate.scad", 20, 10, std::string("--engine ") + engine).out, one) << engine;
    }
}

TEST_F(Pick, BeginsInsideWhereTheEyeIs) {
    folder_.write("inside.scad", "cube(500, center = true);");
    const Json s = surfaces("inside.scad", 3, 3);
    ASSERT_EQ(s.size(), 1u);
    EXPECT_EQ(s[0].at("leaving"), true);
    EXPECT_EQ(s[0].at("in_front"), Json({"model"}));
    EXPECT_EQ(s[0].at("behind"), Json::array());
    EXPECT_NEAR(s[0].at("distance").get<double>(), 350, 1e-6);
}

TEST_F(Pick, TellsTheMaterialOnEitherSide) {
    folder_.write("two.scad",
                  "module lid() cube([4, 4, 2]);\nmodule body() translate([0, 0, -2]) cube([4, 4, 2]);\n"
                  "difference() { union() { color(\"red\") lid(); color(\"lime\") body(); } cube([2, 9, 1]); }");
    const Json whole = surfaces("two.scad", 3, 3);
    EXPECT_EQ(whole.size(), 2u);
    const Json s = surfaces("two.scad", 3, 3, "--parts module=lid,body");
    ASSERT_EQ(s.size(), 4u);
    EXPECT_EQ(s[0].at("behind"), Json({"lid"}));
    for (const int i : {1, 2}) {  // Where they touch, either has its face.
        EXPECT_NEAR(s[i].at("point")[2].get<double>(), 0, 1e-6);
        EXPECT_EQ(s[i].at("in_front"), Json({"lid"}));
        EXPECT_EQ(s[i].at("behind"), Json({"body"}));
    }
    EXPECT_EQ(s[3].at("in_front"), Json({"body"}));
    // A cut face: made by what has no color, of what is red.
    const Json cut = surfaces("two.scad", 1, 3, "--parts module=lid,body");
    ASSERT_EQ(cut.size(), 4u);
    EXPECT_EQ(cut[1].at("shape"), "cube");
    EXPECT_EQ(cut[1].at("operation"), "subtracts");
    EXPECT_EQ(cut[1].at("color"), nullptr);
    EXPECT_EQ(cut[1].at("part").at("name"), "lid");
    EXPECT_EQ(cut[1].at("part").at("color"), "#ff0000");
    EXPECT_EQ(cut[1].at("in_front"), Json({"lid"}));
    EXPECT_EQ(cut[1].at("behind"), Json::array());
    EXPECT_EQ(cut[2].at("part").at("color"), "#00ff00");
}

TEST_F(Pick, ModifiersAndTranslucentPartsAreTold) {
    folder_.write("parts.scad",
                  "color(\"blue\", 0.25) translate([0, 0, 9]) cube(3);\n%translate([0, 0, 5]) cube(3);\n#cube(3);\n");
    const Json s = surfaces("parts.scad", 1, 1);
    std::vector<std::string> kinds;
    for (const Json& surface : s) {
        kinds.push_back(surface.at("part").at("kind"));
    }
    EXPECT_EQ(kinds, (std::vector<std::string>{"translucent", "translucent", "background", "background", "highlight",
                                               "highlight"}));
    EXPECT_EQ(s[0].at("color"), "#0000ff40");
    EXPECT_EQ(surfaces("parts.scad", 1, 1, "--render").size(), 4u) << "a result has neither % nor #";
    EXPECT_EQ(surfaces("parts.scad", 1, 1, "--layers 3").size(), 3u);
}

TEST_F(Pick, CountsPixelsFromTheUpperLeft) {
    folder_.write("corner.scad", "translate([-10, 2, 0]) cube(8);");  // Left and up of the middle.
    const auto count = [&](const char* at) {
        const Result result = run(fmt::format(
            "pick corner.scad --format json --at {} --imgsize 40,20 --projection o --camera=0,0,0,0,0,0,100", at));
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(result.out).at("surfaces").size();
    };
    EXPECT_EQ(count("17,7"), 2u);
    EXPECT_EQ(count("17,12"), 0u);
    EXPECT_EQ(count("22,7"), 0u);
}

TEST_F(Pick, SaysItForPeople) {
    folder_.write("plate.scad", kPlate);
    folder_.write("lib.scad", kLib);
    EXPECT_EQ(look("plate.scad", 20, 10, "--projection o --layers 1 --parts top").out,
              "Behind pixel 5,5 of 11 × 11: 1 surface\n"
              "\n"
              "1  98 away, at [20, 10, 2]\n"
              "   cut by cylinder (leaf 2, subtracts), no color\n"
              "   part plate, #ff8000: from outside into plate\n"
              "     plate()                     plate.scad:9:1\n"
              "     difference()                plate.scad:5:16\n"
              "     for (i = [1:3])             plate.scad:7:3  (child 2 of 3)\n"
              "     translate([10 * i, 10, 0])  plate.scad:7:19\n"
              "     hole(d = 5)                 plate.scad:7:46\n"
              "     translate([0, 0, 2])        plate.scad:3:3\n"
              "     cylinder(d = d, h = 12)     plate.scad:3:24\n");
    EXPECT_EQ(look("plate.scad", -20, 10).out, "Behind pixel 5,5 of 11 × 11: nothing\n");
    folder_.write("marked.scad", "\xEF\xBB\xBF\tcube(  4,\n center = true );");
    EXPECT_NE(look("marked.scad", 0, 0).out.find("     cube( 4, center = true )  marked.scad:1:2\n"), std::string::npos)
        << look("marked.scad", 0, 0).out;
    folder_.write("empty.scad", "");
    EXPECT_EQ(look("empty.scad", 0, 0).out, "Behind pixel 5,5 of 11 × 11: nothing\n");
}

TEST_F(Pick, SaysWhatIsWrong) {
    const auto expect = [&](const std::string& arguments, const std::string& message) {
        const Result result = run("pick " + arguments);
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    };
    expect("m.scad", "--at is required");
    expect("m.scad --at 512,0", "--at 512,0: expected whole numbers, from 0,0 to 511,511");
    expect("m.scad --at 1.5,0", "expected whole numbers");
    expect("m.scad --at -1,0", "expected whole numbers");
    expect("m.scad --at 1", "--at 1: ");
    expect("m.scad --at 1,1 --format xml", "--format xml: expected text, json.");
    expect("m.scad --at 1,1 -o x.png", "unknown option -o.");
    expect("m.scad --at 1,1 --parts tops", "--parts tops: expected model, top, color, depth=N, module=NAME[,NAME].");
    expect("m.scad --at 1,1 --parts depth=0", "--parts depth 0: ");
    expect("m.scad --at 1,1 --parts module=,a", "--parts module=,a: expected module=NAME[,NAME]");
    expect("missing.scad --at 1,1", "missing.scad");
    expect("--at 1,1", "no input file");
    const Result help = run("pick --help");
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("--at X,Y"), std::string::npos) << help.out;
    EXPECT_EQ(help.out.find("--style STYLE"), std::string::npos);
}

}  // namespace
