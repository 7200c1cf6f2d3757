#include "csg/solid/text_outline.h"

#include <gtest/gtest.h>

#include "csg/tree/box.h"

namespace {

using namespace csg::solid;

csg::Box box_of(const csg::Text& text) {
    FontLibrary fonts;
    csg::Box box;
    for (const Loop& loop : text_outline(text, fonts).loops) {
        for (const glm::dvec2& p : loop) {
            box = csg::enclose(box, glm::dvec3(p, 0.0));
        }
    }
    return box;
}

csg::Text text_of(std::string words) {
    csg::Text text;
    text.text = std::move(words);
    text.font = std::string("Liberation Sans");
    return text;
}

/// The corners of OpenSCAD 2021.01's `text("H", font = "Liberation Sans")`.
TEST(Text, StandsWhereOpenScadsDoes) {
    const csg::Text text = text_of("H");
    const csg::Box box = box_of(text);
    if (box.empty()) {
        GTEST_SKIP() << "no font";
    }
    EXPECT_NEAR(box.lo.x, 1.1393, 1e-3);
    EXPECT_NEAR(box.hi.x, 8.89699, 1e-3);
    EXPECT_NEAR(box.lo.y, 0, 1e-9);
    EXPECT_NEAR(box.hi.y, 9.55479, 1e-3);
}

TEST(Text, AlignsByItsExtent) {
    csg::Text text = text_of("Hg");
    text.valign = std::string("top");
    EXPECT_NEAR(box_of(text).hi.y, 0, 1e-9);
    text.valign = std::string("bottom");
    EXPECT_NEAR(box_of(text).lo.y, 0, 1e-9);
    text.valign = std::string("center");
    EXPECT_NEAR(box_of(text).lo.y, -box_of(text).hi.y, 1e-9);
}

/// Without vertical metrics in the font a letter takes the font's height of a line, 1922 of 2048 of an em.
TEST(Text, DownwardsEachLetterHasALine) {
    csg::Text text = text_of("H");
    text.direction = std::string("ttb");
    const csg::Box one = box_of(text);
    if (one.empty()) {
        GTEST_SKIP() << "no font";
    }
    text.text = "HHH";
    const csg::Box three = box_of(text);
    const double line = 1922.0 / 2048 * 10 * 100 / 72;
    EXPECT_NEAR(three.hi.y, one.hi.y, 1e-9);
    EXPECT_NEAR(one.lo.y - three.lo.y, 2 * line, 1e-3);
    EXPECT_NEAR(one.hi.y + one.lo.y, -line, 0.01) << "in the middle of it";
    EXPECT_NEAR(one.lo.x, -one.hi.x, 0.1) << "below the origin";
}

TEST(Text, SizeAndSpacingScale) {
    csg::Text text = text_of("HH");
    const csg::Box one = box_of(text);
    text.size = 20;
    EXPECT_NEAR(box_of(text).hi.x, 2 * one.hi.x, 1e-9);
    text.size = 10;
    text.spacing = 2;
    EXPECT_GT(box_of(text).hi.x, 1.4 * one.hi.x);
    text.size = 0;
    EXPECT_TRUE(box_of(text).empty());
}

TEST(Text, MetricsAreOpenScads) {
    FontLibrary fonts;
    std::vector<std::string> warnings;
    const auto metrics = text_metrics(text_of("hello"), fonts, warnings);
    ASSERT_TRUE(metrics);
    EXPECT_NEAR(metrics->advance.x, 29.3443, 1e-4);
    EXPECT_NEAR(metrics->position.x, 0.96, 1e-12);
    EXPECT_NEAR(metrics->size.y, 10.208, 1e-12);
    EXPECT_NEAR(metrics->ascent, 10.0672, 1e-12);
    EXPECT_NEAR(metrics->descent, -0.1408, 1e-12);
    const auto font = font_metrics(text_of(""), fonts, warnings);
    ASSERT_TRUE(font);
    EXPECT_NEAR(font->nominal_ascent, 12.5733, 1e-4);
    EXPECT_NEAR(font->max_descent, -4.2114, 1e-4);
    EXPECT_NEAR(font->interline, 15.9709, 1e-4);
    EXPECT_EQ(font->family, "Liberation Sans");
    EXPECT_TRUE(warnings.empty());
}

TEST(Text, MetricsOfTextWithoutInkAreItsAdvance) {
    FontLibrary fonts;
    std::vector<std::string> warnings;
    const auto metrics = text_metrics(text_of("  "), fonts, warnings);
    ASSERT_TRUE(metrics);
    EXPECT_GT(metrics->advance.x, 0);
    EXPECT_EQ(metrics->size, glm::dvec2(0.0));
    EXPECT_EQ(metrics->ascent, 0);
}

/// What the metrics say of the box is where the outline lies, for every alignment: to half a pixel of the metrics.
TEST(Text, MetricsEncloseTheOutline) {
    FontLibrary fonts;
    for (const char* halign : {"left", "center", "right"}) {
        for (const char* valign : {"top", "center", "baseline", "bottom"}) {
            csg::Text text = text_of("gÅj");
            text.halign = halign;
            text.valign = valign;
            std::vector<std::string> warnings;
            const auto metrics = text_metrics(text, fonts, warnings);
            ASSERT_TRUE(metrics);
            const csg::Box box = box_of(text);
            EXPECT_NEAR(metrics->position.x, box.lo.x, 0.01) << halign << valign;
            EXPECT_NEAR(metrics->position.y, box.lo.y, 0.02) << halign << valign;
            EXPECT_NEAR(metrics->size.x, box.hi.x - box.lo.x, 0.02) << halign << valign;
            EXPECT_NEAR(metrics->size.y, box.hi.y - box.lo.y, 0.02) << halign << valign;
        }
    }
}

TEST(Text, UnknownAlignmentsAreToldByTheMetrics) {
    FontLibrary fonts;
    csg::Text text = text_of("x");
    text.halign = "middle";
    std::vector<std::string> warnings;
    ASSERT_TRUE(text_metrics(text, fonts, warnings));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0], "Unknown value for the halign parameter (use \"left\", \"right\" or \"center\"): 'middle'");
}

}  // namespace
