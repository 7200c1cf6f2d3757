#include "tests/plot/plot.h"

#include <gtest/gtest.h>

namespace {

TEST(Plot, PutsValuesWhereTheyBelong) {
    plot::Plot p{"t", {"x", true, true}, {"y", false, false}, {{"a", {{100, 0}, {1, 10}}}}, true, 420, 260};
    const std::string svg = plot::to_svg(p);
    // Descending: 100 is at the left end, 1 at the right; 0 is at the bottom, 10 at the top.
    EXPECT_NE(svg.find("M62.0 214.0L406.0 30.0"), std::string::npos) << svg;
}

TEST(Plot, KeepsZeroOnALogarithmicAxisAndEscapesText) {
    plot::Plot p{"a < b & c", {"x", false, false}, {"y", true, false}, {{"s", {{0, 0}, {1, 1}}}}, true, 420, 260};
    const std::string svg = plot::to_svg(p);
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
    EXPECT_NE(svg.find("M62.0 214.0L"), std::string::npos) << svg;
}

TEST(Plot, LabelsPoints) {
    plot::Plot p{"t", {"x", false, false}, {"y", false, false}, {{"s", {{0, 0}, {1, 1}}, {"first", "<2>"}}}};
    const std::string svg = plot::to_svg(p);
    EXPECT_NE(svg.find("y=\"211.0\" font-size=\"8\" fill=\"#1f4e9e\">first<"), std::string::npos) << svg;
    EXPECT_NE(svg.find(">&lt;2&gt;<"), std::string::npos);
}

TEST(Plot, NamesOfSeriesDoNotOverlap) {
    const std::string name(30, 'n');
    plot::Plot p{"t", {"x", false, false}, {"y", false, false}, {}};
    for (int i = 0; i < 3; ++i) {
        p.series.push_back({name, {{0, 0}}});
    }
    const std::string svg = plot::to_svg(p);
    // Each takes half of the width: one in a line.
    for (const char* y : {"x=\"62\" y=\"228\"", "x=\"62\" y=\"242\"", "x=\"62\" y=\"256\""}) {
        EXPECT_NE(svg.find(y), std::string::npos) << y << '\n' << svg;
    }
}

TEST(Plot, OfNothingIsAPicture) {
    EXPECT_NE(plot::to_svg({"", {}, {}, {}, true, 420, 260}).find("</svg>"), std::string::npos);
}

}  // namespace
