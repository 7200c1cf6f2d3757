#include "ui/command_line/section_text.h"

#include <gtest/gtest.h>

#include "ui/command_line/usage_error.h"

namespace ui {
namespace {

npr::PlaneSection plane(const std::string& text) {
    const npr::Section section = read_section(text);
    EXPECT_EQ(section.text, text);
    EXPECT_TRUE(std::holds_alternative<npr::PlaneSection>(section.cut)) << text;
    return std::get<npr::PlaneSection>(section.cut);
}

TEST(SectionText, PlanesAcrossAnAxis) {
    using enum npr::PlaneSection::Away;
    EXPECT_EQ(plane("z=12"), (npr::PlaneSection{{0, 0, 1}, 12, Eye}));
    EXPECT_EQ(plane("x > -1.5"), (npr::PlaneSection{{1, 0, 0}, -1.5, Beyond}));
    EXPECT_EQ(plane("y<2e1"), (npr::PlaneSection{{0, -1, 0}, -20, Beyond}));
}

TEST(SectionText, PlanesByPointAndNormal) {
    for (const char* const text : {"plane([1,2,3],[0,0,2])", "plane(1,2,3,0,0,2)", "plane( [1, 2, 3], [0, 0, 2] )"}) {
        EXPECT_EQ(plane(text), (npr::PlaneSection{{0, 0, 1}, 3, npr::PlaneSection::Away::Beyond})) << text;
    }
}

TEST(SectionText, Boxes) {
    const npr::Section box = read_section("box([3,0,5],[1,2,4])");
    EXPECT_EQ(std::get<npr::BoxSection>(box.cut), (npr::BoxSection{{1, 0, 4}, {3, 2, 5}})) << "any two corners";
}

TEST(SectionText, CornersAndParts) {
    EXPECT_EQ(std::get<npr::CornerSection>(read_section("half").cut).axes, 1);
    EXPECT_EQ(std::get<npr::CornerSection>(read_section("quarter").cut).axes, 2);
    EXPECT_EQ(std::get<npr::CornerSection>(read_section("eighth").cut).axes, 3);
    EXPECT_EQ(std::get<npr::PartSection>(read_section("part:part 3").cut).part, "part 3");
}

TEST(SectionText, WhatIsNoneIsToldWithWhatIsExpected) {
    for (const char* const text : {"", "z", "z=", "z=a", "w=3", "z=1,2", "plane", "plane()", "plane([1,2,3])",
                                   "plane([1,2,3],[0,0,0])", "plane([1,2,3],[0,0])", "plane([1,2,3,0,0,1)",
                                   "box([0,0,0],[1,1,0])", "box", "quarters", "part:", "z=nan", "z=1e999"}) {
        try {
            (void)read_section(text);
            ADD_FAILURE() << text << " is taken";
        } catch (const UsageError& error) {
            const std::string said = error.what();
            EXPECT_NE(said.find("--section"), std::string::npos) << said;
        }
    }
}

TEST(SectionText, ListsAndHatching) {
    const npr::Sections all = read_sections({"z=1", "half"}, {"shaft,bolt", "nut"}, "2.5");
    EXPECT_EQ(all.cuts.size(), 2U);
    EXPECT_EQ(all.uncut, (std::vector<std::string>{"shaft", "bolt", "nut"}));
    EXPECT_EQ(all.spacing, 2.5);
    EXPECT_EQ(read_sections({"z=1"}, {}, "").spacing, npr::Sections::kOwnSpacing);
    EXPECT_THROW((void)read_sections({}, {"shaft"}, ""), UsageError) << "of no section";
    EXPECT_THROW((void)read_sections({}, {}, "1"), UsageError);
    EXPECT_THROW((void)read_sections({"z=1"}, {"shaft,,bolt"}, ""), UsageError);
    EXPECT_THROW((void)read_sections({"z=1"}, {}, "-1"), UsageError);
}

}  // namespace
}  // namespace ui
