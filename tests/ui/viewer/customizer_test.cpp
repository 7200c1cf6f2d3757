// Values that are chosen in the window, and parameter sets in their file.
#include "ui/viewer/customizer.h"

#include <gtest/gtest.h>

#include "csg/scad/syntax/parser.h"
#include "tests/support/temporary_folder.h"
#include "ui/viewer/customizer_panel.h"

namespace ui {
namespace {

std::vector<csg::scad::CustomizerParameter> parameters(const std::string& text) {
    using namespace csg::scad;
    return customizer_parameters(parse({"test.scad", text, {}, read_source_file, {}}).program);
}

const std::string kText = "width = 10; // [5:2:50]\nname = \"a\"; // 3\nround = true;\nat = [1, 2];\n";

class CustomizerTest : public testing::Test {
  protected:
    CustomizerTest() : customizer_(folder_.path("model.json")) { customizer_.receive(parameters(kText)); }

    test_support::TemporaryFolder folder_;
    Customizer customizer_;
};

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

TEST_F(CustomizerTest, OnlyWhatDiffersFromTheTextIsDefined) {
    EXPECT_EQ(customizer_.definitions(), Texts{});
    customizer_.set("width", 12.0);
    customizer_.set("name", "b\"");
    customizer_.set("at", Numbers{3, 4});
    customizer_.set("unknown", 1.0);
    EXPECT_EQ(customizer_.definitions(), (Texts{"at=[3, 4]", "name=\"b\\\"\"", "width=12"}));
    EXPECT_TRUE(customizer_.changed(customizer_.parameters()[0]));
    customizer_.set("width", 10.0);
    customizer_.reset("at");
    EXPECT_EQ(customizer_.definitions(), Texts{"name=\"b\\\"\""});
    customizer_.reset("");
    EXPECT_FALSE(customizer_.any_changed());
}

TEST_F(CustomizerTest, AnotherTextKeepsWhatFitsIt) {
    customizer_.set("width", 40.0);
    customizer_.set("name", "b");
    customizer_.set("round", false);
    customizer_.receive(parameters("width = 10; // [5:20]\nname = 1;\nround = true;\n"));
    EXPECT_EQ(customizer_.definitions(), (Texts{"round=false", "width=20"}));
    customizer_.receive(parameters("round = false;\n"));
    EXPECT_EQ(customizer_.definitions(), Texts{}) << "that is what the text says now";
}

TEST_F(CustomizerTest, SetsAreSavedAndUsed) {
    customizer_.set("width", 30.0);
    customizer_.save("wide");
    customizer_.set("name", "ab");
    customizer_.set("width", 6.0);
    customizer_.save("small");
    ASSERT_EQ(customizer_.error(), "");
    EXPECT_EQ(customizer_.used(), "small");
    ASSERT_EQ(customizer_.sets().size(), 2U);
    EXPECT_EQ(*customizer_.sets()[1].find("name"), "ab");
    EXPECT_EQ(*customizer_.sets()[1].find("at"), "[1, 2]");
    customizer_.use("wide");
    EXPECT_EQ(customizer_.definitions(), Texts{"width=30"});

    Customizer other(folder_.path("model.json"));
    other.receive(parameters(kText));
    other.use("small");
    EXPECT_EQ(other.definitions(), (Texts{"name=\"ab\"", "width=6"}));
    other.remove("small");
    customizer_.receive(parameters(kText));
    ASSERT_EQ(customizer_.sets().size(), 1U);
    EXPECT_EQ(customizer_.sets()[0].name, "wide");
}

TEST_F(CustomizerTest, WhatElseIsInTheFileStays) {
    folder_.write("model.json",
                  "{\"parameterSets\": {\"old\": {\"width\": \"20\", \"gone\": \"x\"}}, \"fileFormatVersion\": \"1\", "
                  "\"other\": [1]}");
    customizer_.save("new");
    ASSERT_EQ(customizer_.error(), "");
    ASSERT_EQ(customizer_.sets().size(), 2U);
    EXPECT_EQ(*customizer_.sets()[0].find("gone"), "x");
    EXPECT_NE(folder_.read("model.json").find("\"other\""), std::string::npos);
}

TEST_F(CustomizerTest, AFileOfSomethingElseIsNotReplaced) {
    for (const std::string text : {"{\"parameterSets\": ", "[1, 2]", "{\"name\": \"package\"}"}) {
        folder_.write("model.json", text);
        customizer_.save("mine");
        EXPECT_NE(customizer_.error(), "") << text;
        EXPECT_EQ(folder_.read("model.json"), text);
        customizer_.remove("mine");
        EXPECT_EQ(folder_.read("model.json"), text);
    }
    Customizer nowhere(folder_.path("missing/model.json"));
    nowhere.receive(parameters(kText));
    EXPECT_EQ(nowhere.error(), "");
    nowhere.save("mine");
    EXPECT_NE(nowhere.error(), "");
}

TEST_F(CustomizerTest, NumbersLieOnTheirSteps) {
    const auto p = parameters("a = 6; // [5:2:50]\nb = 1; // 0.5\nc = 0.3; // [0:0.1:1]\n");
    EXPECT_EQ(on_step(p[0], 12.9), 13);
    EXPECT_EQ(on_step(p[0], 49.9), 49) << "the step before the end";
    EXPECT_EQ(on_step(p[0], -3), 5);
    EXPECT_EQ(on_step(p[1], 1.3), 1.3) << "no range, no grid";
    EXPECT_NEAR(on_step(p[2], 0.44), 0.4, 1e-15);
}

}  // namespace
}  // namespace ui
