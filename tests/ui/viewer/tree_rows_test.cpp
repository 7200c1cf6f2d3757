// The model as a tree of calls, and the shapes of one of them.
#include "ui/viewer/tree_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.h"
#include "ui/viewer/ghost.h"
#include "ui/viewer/revision.h"

namespace ui {
namespace {

class TreeRowsTest : public testing::Test {
  protected:
    TreeRowsTest() {
        revision_ = make_evaluate()(
            Source{folder_.write("lid.scad",
                                 "module hole() { cylinder(r = 2, h = 30, $fn = 24); }\n"
                                 "color(\"red\") difference() {\n  cube(10);\n  hole();\n}\nsphere(1);\n"),
                   {},
                   {},
                   true,
                   false},
            {}, {});
        rows_ = tree_rows(*revision_.model, *revision_.sources);
    }
    const TreeRow& row(const std::string& begin) const {
        const auto found =
            std::find_if(rows_.begin(), rows_.end(), [&](const TreeRow& each) { return each.call.starts_with(begin); });
        EXPECT_NE(found, rows_.end()) << begin;
        return found == rows_.end() ? rows_.front() : *found;
    }
    Ghost ghost(const std::string& begin) const { return ghost_of(*revision_.model, row(begin).occurrence); }

    test_support::TemporaryFolder folder_;
    Revision revision_;
    std::vector<TreeRow> rows_;
};

TEST_F(TreeRowsTest, RowsAreTheCallsInTheirOrder) {
    std::string text;
    for (const TreeRow& each : rows_) {
        text += std::string(static_cast<std::size_t>(each.depth), ' ') + each.call.substr(0, each.call.find('(')) +
                " " + each.place + "\n";
    }
    EXPECT_EQ(text,
              "color lid.scad:2\n difference lid.scad:2\n  cube lid.scad:3\n  hole lid.scad:4\n"
              "   cylinder lid.scad:1\nsphere lid.scad:6\n");
    EXPECT_EQ(row("color").end, 5U);
    EXPECT_EQ(row("cube").end, 3U);
    EXPECT_EQ(row("difference").at, (CallAt{"difference", folder_.path("lid.scad"), 2, 14}));
    ASSERT_TRUE(row("cube").color);
    EXPECT_EQ(row("cube").color->r, 1);
    EXPECT_FALSE(row("sphere").color);
    EXPECT_EQ(row("cube").text.range.line, 3U);
    EXPECT_EQ(tree_rows(*revision_.model, *revision_.sources, 2).size(), 2U);
}

TEST_F(TreeRowsTest, AFilterKeepsTheRowsAbove) {
    const auto shown = [&](const char* text) {
        std::string kept;
        const std::vector<char> all = filtered(rows_, text);
        std::for_each(all.begin(), all.end(), [&](char each) { kept += each != 0 ? 'x' : '.'; });
        return kept;
    };
    EXPECT_EQ(shown(""), "xxxxxx");
    EXPECT_EQ(shown("CYL"), "xx.xx.");
    EXPECT_EQ(shown("scad:6"), ".....x");
    EXPECT_EQ(shown("cone"), "......");
}

TEST_F(TreeRowsTest, AGhostIsOfAllBelowACall) {
    const Ghost cutter = ghost("hole");
    EXPECT_TRUE(cutter.cuts);
    EXPECT_EQ(cutter.creases.size(), 48U) << "two circles";
    double highest = 0;
    for (const auto& triangle : cutter.triangles) {
        highest = std::max({highest, triangle[0].z, triangle[1].z, triangle[2].z});
    }
    EXPECT_EQ(highest, 30) << "all of it, not only what it cuts";
    EXPECT_FALSE(ghost("cube").cuts);
    EXPECT_EQ(ghost("cube").triangles.size(), 12U);
    EXPECT_EQ(ghost("color").triangles.size(), 12 + cutter.triangles.size());
    EXPECT_TRUE(ghost_of(*revision_.model, csg::kNoOccurrence).triangles.empty());
    EXPECT_TRUE(ghost_of(*revision_.model, row("color").occurrence, 20).triangles.empty()) << "too much to draw";
}

}  // namespace
}  // namespace ui
