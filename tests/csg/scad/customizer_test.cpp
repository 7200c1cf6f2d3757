// Parameters of the main file, and what of a parameter set fits them.
#include "csg/scad/customizer/customizer.h"

#include <gtest/gtest.h>

#include "csg/scad/syntax/parser.h"

namespace {

using namespace csg::scad;

std::vector<CustomizerParameter> parameters(const std::string& text) {
    return customizer_parameters(parse({"test.scad", text, {}, read_source_file, {}}).program);
}

std::optional<std::string> fitted_expression(const CustomizerParameter& parameter, std::string_view text) {
    const auto value = fitted_value(parameter, text);
    return value ? std::optional(expression_of(*value)) : std::nullopt;
}

TEST(Customizer, KindsAndForms) {
    const auto p = parameters(
        "// How wide\nwidth = 10; // [5:2:50]\n/* [Look] */\nname = \"a\"; // 8\nround = true;\n"
        "size = -1; // [-1:S, 2:L]\npoint = [1, -2]; // [10]\n/* [Hidden] */\nsecret = 1;\n");
    ASSERT_EQ(p.size(), 5U);
    EXPECT_EQ(p[0].caption, "How wide");
    EXPECT_EQ(p[0].group, "Parameters");
    EXPECT_EQ(p[0].minimum, 5);
    EXPECT_EQ(p[0].step, 2);
    EXPECT_EQ(p[0].maximum, 50);
    EXPECT_EQ(p[1].group, "Look");
    EXPECT_EQ(p[1].longest, 8U);
    EXPECT_TRUE(std::get<bool>(p[2].initial));
    ASSERT_EQ(p[3].options.size(), 2U);
    EXPECT_EQ(p[3].options[1].label, "L");
    EXPECT_EQ(std::get<std::vector<double>>(p[4].initial), (std::vector<double>{1, -2}));
    EXPECT_EQ(p[4].maximum, 10);
}

TEST(Customizer, GroupsAreTrimmed) {
    const auto p = parameters(
        "/* [ Hidden ] */ a = 1;\n/* [ Hidden ] */\nb = 1;\n/* [  Main part ] */\nc = 2;\n/* [ One ] [ Two ] */\nd = "
        "3;\n"
        "// a return alone ends no comment, \r { nor does what is behind it\ne = 4;\n");
    ASSERT_EQ(p.size(), 4U);
    EXPECT_EQ(p[0].name, "a") << "a group begins below its line";
    EXPECT_EQ(p[1].group, "Main part");
    EXPECT_EQ(p[2].group, "One - Two");
    EXPECT_EQ(p[3].name, "e");
}

TEST(Customizer, WhatTheFileSaysIsAlwaysAChoice) {
    const auto p = parameters(
        "a = 5; // [1:3]\nb = -4; // [0:2:10]\nc = [1, 20]; // [0:10]\nd = 20; // [10]\ne = 5; // [8:3]\n"
        "f = \"x\"; // [p:P, q]\ng = 7; // [1:One, 2]\nh = 2; // [1, 2]\n");
    ASSERT_EQ(p.size(), 8U);
    const std::pair<double, double> ranges[]{{1, 5}, {-4, 10}, {0, 20}, {0, 20}, {5, 5}};
    for (std::size_t i = 0; i < std::size(ranges); ++i) {
        EXPECT_EQ(std::pair(p[i].minimum.value(), p[i].maximum.value()), ranges[i]) << p[i].name;
    }
    ASSERT_EQ(p[5].options.size(), 3U);
    EXPECT_EQ(p[5].options[0].label, "x");
    EXPECT_EQ(std::get<std::string>(p[5].options[0].value), "x");
    ASSERT_EQ(p[6].options.size(), 3U);
    EXPECT_EQ(p[6].options[0].label, "7");
    EXPECT_EQ(std::get<double>(p[6].options[0].value), 7);
    EXPECT_EQ(p[7].options.size(), 2U);
    EXPECT_EQ(fitted_expression(p[0], "9"), "5");
}

TEST(Customizer, WhatIsComputedIsNoParameter) {
    EXPECT_TRUE(parameters("a = 1 + 1; b = [1, 2, 3, 4, 5]; c = [\"x\"]; d = undef;").empty());
    EXPECT_TRUE(parameters("module m() { a = 1; }").empty());
    EXPECT_TRUE(parameters("a = ;").empty());
}

TEST(Customizer, SetsFit) {
    const auto p = parameters("n = 3; // [0:10]\ns = \"x\";\nb = true;\no = 1; // [1:A, 2:B]\nv = [1, 2];\n");
    ASSERT_EQ(p.size(), 5U);
    EXPECT_EQ(fitted_expression(p[0], " 4.5 "), "4.5");
    EXPECT_EQ(fitted_expression(p[0], "400"), "10");
    EXPECT_EQ(fitted_expression(p[0], "four"), std::nullopt);
    EXPECT_EQ(fitted_expression(p[1], "a \"b\" \\"), "\"a \\\"b\\\" \\\\\"");
    EXPECT_EQ(fitted_expression(p[2], "false"), "false");
    EXPECT_EQ(fitted_expression(p[2], "0"), std::nullopt);
    EXPECT_EQ(fitted_expression(p[3], "2"), "2");
    EXPECT_EQ(fitted_expression(p[3], "3"), std::nullopt);
    EXPECT_EQ(fitted_expression(p[4], "[3,  4]"), "[3, 4]");
    EXPECT_EQ(fitted_expression(p[4], "[3]"), std::nullopt);
    EXPECT_EQ(fitted_expression(p[4], "[3, x]"), std::nullopt);
    EXPECT_EQ(fitted_expression(p[4], "["), std::nullopt);
}

}  // namespace
