#include "csg/solid/text_outline.h"

#include <gtest/gtest.h>

#include "csg/tree/box.h"

namespace {

using namespace csg::solid;

csg::Box box_of(const csg::Text& text) {
    FontLibrary fonts;
    std::vector<std::string> warnings;
    csg::Box box;
    for (const Loop& loop : text_outline(text, fonts, warnings).loops) {
        for (const glm::dvec2& p : loop)
            box = csg::enclose(box, glm::dvec3(p, 0.0));
    }
    EXPECT_TRUE(warnings.empty()) << warnings[0];
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
    if (box.empty())
        GTEST_SKIP() << "no font";
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
    if (one.empty())
        GTEST_SKIP() << "no font";
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

}  // namespace
