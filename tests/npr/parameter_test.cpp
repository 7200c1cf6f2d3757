// Parameters of styles, and the lists of styles and color schemes.
#include "npr/parameter.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "npr/style.h"

namespace {

using npr::Parameter;
using npr::Parameters;

std::vector<Parameter> all_kinds() {
    return {Parameter::number("width", "Width", 1.5F, 0.25F, 4), Parameter::integer("layers", "Layers", 3, 0, 9),
            Parameter::toggle("grid", "Grid", false), Parameter::color("ink", "Ink", {1, 0, 0}),
            Parameter::choice("ground", "Ground", 1, {"blue", "white"})};
}

std::string refusal(Parameters& p, std::string_view name, std::string_view text) {
    try {
        p.read(name, text);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

TEST(Parameters, DefaultsAndText) {
    const auto list = all_kinds();
    Parameters p(list);
    EXPECT_EQ(std::get<float>(p.at(0)), 1.5F);
    EXPECT_EQ(std::get<int>(p.at(4)), 1);
    p.read("width", "0.25");
    p.read("layers", "9");
    p.read("grid", "on");
    p.read("ink", "#336699");
    p.read("ground", "blue");
    EXPECT_EQ(std::get<float>(p.at(0)), 0.25F);
    EXPECT_EQ(std::get<int>(p.at(1)), 9);
    EXPECT_TRUE(std::get<bool>(p.at(2)));
    EXPECT_EQ(std::get<glm::vec3>(p.at(3)), glm::vec3(0x33, 0x66, 0x99) / 255.0F);
    EXPECT_EQ(std::get<int>(p.at(4)), 0);
    p.read("ink", "#369");
    EXPECT_EQ(npr::text(list[3], p.at(3)), "#336699");
    for (std::size_t i = 0; i < 5; ++i) {
        Parameters again(list);
        const Parameter& parameter = list[i];
        again.read(parameter.name, npr::text(parameter, p.at(i)));
        EXPECT_EQ(again.at(i), p.at(i)) << parameter.name;
    }
}

TEST(Parameters, LengthsAreInPixelsOrMillimeters) {
    const std::vector<Parameter> list{Parameter::length("width", "Width", 1.5F, 0.25F, 4)};
    Parameters p(list);
    EXPECT_FALSE(p.in_millimeters(0));
    p.read("width", "0.35mm");
    EXPECT_TRUE(p.in_millimeters(0));
    EXPECT_EQ(std::get<float>(p.at(0)), 0.35F);
    Parameters other(list);
    other.read("width", "0.35px");
    EXPECT_FALSE(other.in_millimeters(0));
    EXPECT_NE(p, other);
    p.read("width", "40");  // Beyond the range of its control.
    EXPECT_FALSE(p.in_millimeters(0));
    for (const char* text : {"-1", "mm", "1cm", "1 mm", "1001"}) {
        EXPECT_EQ(
            refusal(p, "width", text),
            std::string("width takes a length up to 1000 in pixels, or in millimeters as 0.35mm, not \"") + text + '"');
    }
    EXPECT_EQ(std::get<float>(p.at(0)), 40);
}

TEST(Parameters, RefusedValuesChangeNothing) {
    const auto list = all_kinds();
    Parameters p(list);
    EXPECT_EQ(refusal(p, "width", "5"), "width takes a number from 0.25 to 4, not \"5\"");
    EXPECT_EQ(refusal(p, "width", "nan"), "width takes a number from 0.25 to 4, not \"nan\"");
    EXPECT_EQ(refusal(p, "width", "1,5"), "width takes a number from 0.25 to 4, not \"1,5\"");
    EXPECT_EQ(refusal(p, "width", ""), "width takes a number from 0.25 to 4, not \"\"");
    EXPECT_EQ(refusal(p, "layers", "2.5"), "layers takes a whole number from 0 to 9, not \"2.5\"");
    EXPECT_EQ(refusal(p, "layers", "99999999999"), "layers takes a whole number from 0 to 9, not \"99999999999\"");
    EXPECT_EQ(refusal(p, "grid", "maybe"), "grid takes on or off, not \"maybe\"");
    EXPECT_EQ(refusal(p, "ink", "#12345"), "ink takes a color as #rrggbb, not \"#12345\"");
    EXPECT_EQ(refusal(p, "ink", "#12g"), "ink takes a color as #rrggbb, not \"#12g\"");
    EXPECT_EQ(refusal(p, "ground", "red"), "ground takes one of blue, white, not \"red\"");
    EXPECT_EQ(refusal(p, "witdh", "1"), "no parameter \"witdh\"; did you mean \"width\"?");
    EXPECT_THROW(p.set(0, npr::Value(true)), std::invalid_argument);
    EXPECT_THROW(p.set("width", npr::Value(true)), std::invalid_argument);
    EXPECT_THROW(p.set("witdh", npr::Value(1.0F)), std::invalid_argument);
    EXPECT_THROW(p.set(4, npr::Value(2)), std::invalid_argument);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(p.at(i), list[i].initial);
    }
}

TEST(Styles, NamesAreUniqueAndDefaultsValid) {
    std::set<std::string_view> names;
    for (const npr::StyleInfo& style : npr::styles()) {
        EXPECT_TRUE(names.insert(style.name).second) << style.name;
        EXPECT_EQ(npr::find_style(style.name), &style);
        Parameters p(style.parameters);
        std::set<std::string_view> parameters;
        for (const Parameter& parameter : p.list()) {
            EXPECT_TRUE(parameters.insert(parameter.name).second) << style.name << ' ' << parameter.name;
            EXPECT_NO_THROW(p.set(parameter.name, parameter.initial)) << style.name << ' ' << parameter.name;
        }
    }
    EXPECT_EQ(npr::styles().front().name, "shaded");
    EXPECT_EQ(npr::find_style("Shaded"), nullptr);
}

TEST(ColorSchemes, AsOpenScadHasThem) {
    EXPECT_EQ(npr::color_schemes().size(), 12U);
    EXPECT_EQ(npr::color_schemes().front().name, "Cornfield");
    const npr::ColorScheme* night = npr::find_color_scheme("Tomorrow Night");
    ASSERT_NE(night, nullptr);
    EXPECT_EQ(night->background, glm::vec3(0x1d, 0x1f, 0x21) / 255.0F);
    EXPECT_EQ(night->background_stop, night->background);
    EXPECT_EQ(night->face, glm::vec3(0x81, 0xa2, 0xbe) / 255.0F);
    EXPECT_EQ(night->cut, glm::vec3(0xde, 0x93, 0x5f) / 255.0F);
    EXPECT_EQ(npr::find_color_scheme("ClearSky")->background_stop, glm::vec3(0xc9, 0xe9, 0xf6) / 255.0F);
    EXPECT_EQ(npr::find_color_scheme("cornfield"), nullptr);
}

}  // namespace
