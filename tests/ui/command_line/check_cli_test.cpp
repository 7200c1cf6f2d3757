// csgscope check as its users run it: exit codes, formats, and errors.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace {

using Json = nlohmann::json;

class CheckProgram : public test_support::ProgramTest {
  protected:
    CheckProgram() : ProgramTest(60) {
        folder_.write("thin.scad",
                      "module cup() difference() {\n"
                      "  cube([20, 20, 10]);\n"
                      "  translate([0.4, 3, 3]) cube([15, 14, 20]);\n"
                      "}\n"
                      "cup();\n");
    }
};

TEST_F(CheckProgram, ExitCodesSayWhatWasFound) {
    EXPECT_EQ(run("check thin.scad --min-wall 0.3").status, 0);
    EXPECT_EQ(run("check thin.scad --min-wall 0.5").status, 1);
    EXPECT_EQ(run("check --help").status, 0);
    for (const char* const bad : {"check thin.scad", "check none.scad --no-effect", "check thin.scad --min-wall 0",
                                  "check thin.scad --min-wal 1", "check thin.scad --clearance cup=1",
                                  "check thin.scad --clearance cup,lid=1", "check thin.scad --max-size 1,2",
                                  "check thin.scad --no-effect --format xml", "check thin.scad --no-effect -D 'a=['"}) {
        const Result result = run(bad);
        EXPECT_EQ(result.status, 2) << bad;
        EXPECT_NE(result.err, "") << bad;
    }
    folder_.write("flat.scad", "square(4);");
    EXPECT_EQ(run("check flat.scad --min-wall 1").status, 2);
    EXPECT_NE(run("check thin.scad --min-wal 1").err.find("--min-wall"), std::string::npos);
}

TEST_F(CheckProgram, TextTellsSizePlaceAndCalls) {
    const Result result = run("check thin.scad --min-wall 0.5");
    EXPECT_NE(result.out.find("thin wall, 0.4 mm, limit 0.5\n   at [0"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("cube([20, 20, 10])  thin.scad:2:3"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("translate([0.4, 3, 3])  thin.scad:3:3"), std::string::npos) << result.out;
}

TEST_F(CheckProgram, FormatsForPrograms) {
    const Json json = Json::parse(run("check thin.scad --min-wall 0.5 --format json").out);
    ASSERT_EQ(json.at("findings").size(), 1u);
    const Json& finding = json.at("findings")[0];
    EXPECT_EQ(finding.at("kind"), "min-wall");
    EXPECT_NEAR(finding.at("value").get<double>(), 0.4, 1e-9);
    EXPECT_LT(finding.at("error").get<double>(), 1e-6);
    EXPECT_EQ(finding.at("calls").back().at("line"), 2);
    EXPECT_EQ(finding.at("other_calls").back().at("line"), 3);

    const Json sarif = Json::parse(run("check thin.scad --min-wall 0.5 --no-effect --format sarif").out);
    EXPECT_EQ(sarif.at("version"), "2.1.0");
    const Json& sarif_run = sarif.at("runs")[0];
    EXPECT_EQ(sarif_run.at("tool").at("driver").at("rules").size(), 2u);
    const Json& place = sarif_run.at("results")[0].at("locations")[0].at("physicalLocation");
    EXPECT_EQ(place.at("artifactLocation").at("uri"), "thin.scad");
    EXPECT_EQ(place.at("region").at("startLine"), 2);

    const std::string junit = run("check thin.scad --min-wall 0.5 --no-effect --format junit").out;
    EXPECT_NE(junit.find("tests=\"2\" failures=\"1\""), std::string::npos) << junit;
    EXPECT_NE(junit.find("<failure message=\"thin wall, 0.4 mm, limit 0.5\">"), std::string::npos) << junit;
}

TEST_F(CheckProgram, ReportHasAPictureOfEachFinding) {
    EXPECT_EQ(run("check thin.scad --min-wall 0.5 --report found").status, 1);
    const std::string page = folder_.read("found/report.html");
    EXPECT_NE(page.find("<img alt=\"the place\""), std::string::npos);
    EXPECT_NE(page.find("thin wall, 0.4 mm"), std::string::npos);
    EXPECT_EQ(Json::parse(folder_.read("found/report.json")).at("findings").size(), 1u);
}

/// Each has a section of its own, by planes in other directions.
TEST_F(CheckProgram, PicturesOfAReportFollowEachOther) {
    folder_.write("box.scad", "difference() { cube([40, 30, 12]); translate([0.4, 0.4, 3]) cube([39.2, 29.2, 20]); }");
    ASSERT_EQ(run("check box.scad --min-wall 0.5 --spacing 1 --report found").status, 1);
    const std::string page = folder_.read("found/report.html");
    std::size_t pictures = 0;
    for (std::size_t at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1)) {
        ++pictures;
    }
    EXPECT_EQ(pictures, 4u);
}

TEST_F(CheckProgram, SummaryTellsMeasuresWithoutAMesh) {
    folder_.write("two.scad", "cube([20, 10, 5]); translate([30, 0, 0]) cube(10);");
    ASSERT_EQ(run("two.scad --parts top --precision 0.02 --summary measures --summary-file facts.json -q").status, 0);
    const Json measures = Json::parse(folder_.read("facts.json")).at("measures");
    EXPECT_NEAR(measures.at("volume").get<double>(), 2000, measures.at("volume_error").get<double>());
    EXPECT_LE(measures.at("volume_error").get<double>(), 40);
    ASSERT_EQ(measures.at("parts").size(), 2u);
    EXPECT_NEAR(measures.at("parts")[0].at("volume").get<double>(), 1000, 20);
    EXPECT_NEAR(measures.at("parts")[1].at("centroid")[0].get<double>(), 35, 0.1);
    for (const char* const bad : {"--precision 0", "--precision 2", "--precision x"}) {
        EXPECT_EQ(run(std::string("two.scad --summary measures ") + bad).status, 1) << bad;
    }
}

}  // namespace
