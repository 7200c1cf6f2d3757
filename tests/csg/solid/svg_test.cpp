// SVG beyond plain shapes: strokes, uses, style sheets, viewports.
#include <gtest/gtest.h>

#include "csg/solid/import_outline.h"
#include "csg/solid/svg_document.h"

namespace {

using namespace csg::solid;

struct Read {
    double area;
    csg::Box box;
    std::vector<std::string> warnings, failures;
};

Read read(const std::string& body, const std::string& head = "width='100mm' height='50mm' viewBox='0 0 100 50'",
          const csg::Import& import = {}) {
    Read result;
    Remarks remarks;
    const Outline outline = read_svg("<svg " + head + ">" + body + "</svg>", import, remarks);
    result.warnings = std::move(remarks.warnings);
    result.failures = std::move(remarks.failures);
    result.area = outline.area();
    result.box = bounds_of(outline.loops);
    return result;
}

double area(const std::string& body) {
    const Read result = read(body);
    EXPECT_TRUE(result.warnings.empty()) << result.warnings[0];
    return result.area;
}

TEST(Svg, OpenLinesAreAsWideAsTheirStrokes) {
    EXPECT_NEAR(area("<line x1='5' y1='5' x2='15' y2='5'/>"), 10, 1e-6) << "1 wide, without caps";
    EXPECT_NEAR(area("<line x1='5' y1='5' x2='15' y2='5' stroke-width='2' stroke-linecap='butt'/>"), 20, 1e-6);
    EXPECT_NEAR(area("<line x1='5' y1='5' x2='15' y2='5' style='stroke-width:2; stroke-linecap:square'/>"), 24, 1e-6);
    EXPECT_NEAR(area("<g stroke-width='8'><line x1='20' y1='9' x2='40' y2='9' stroke-linecap='round'/></g>"),
                160 + 16 * 3.1416, 4);
    const std::string corner = "<path d='M5 5 h10 v10' stroke-width='2' stroke-linecap='butt' ";
    EXPECT_NEAR(area(corner + "/>"), 40, 1e-6) << "mitred";
    EXPECT_LT(area(corner + "stroke-linejoin='bevel'/>"), 39.9);
    EXPECT_LT(area(corner + "stroke-linejoin='round'/>"), 39.9);
    const std::string needle = "<path d='M5 5 H45 L5 9' stroke-linecap='butt' ";
    EXPECT_GT(area(needle + "stroke-miterlimit='40'/>"), area(needle + "/>") + 4) << "as sharp as the limit lets it";
    EXPECT_NEAR(area("<polyline points='5,5 15,5 15,15 5,15 5,5'/>"), 100, 1e-6) << "closed: filled";
}

TEST(Svg, ClosedShapesAreFilledAsInOpenScad) {
    EXPECT_NEAR(area("<rect width='4' height='5' fill='none' stroke-width='2'/>"), 20, 1e-6);
    EXPECT_NEAR(area("<path d='M0 0h4v5h-4z M10 0 h4 l0 1' stroke-linecap='butt'/>"), 20 + 5, 1e-6)
        << "each part of a path by itself";
    EXPECT_NEAR(area("<g fill-rule='evenodd'><path d='M0 0h9v9h-9z M3 3h3v3h-3z'/></g>"), 72, 1e-6);
    EXPECT_NEAR(area("<path fill-rule='nonzero' d='M0 0h9v9h-9z M3 3h3v3h-3z'/>"), 72, 1e-6) << "whatever it says";
    EXPECT_NEAR(area("<path d='M0 0h9v9h-9z'/><path d='M3 3h3v3h-3z'/>"), 81, 1e-6) << "each by itself";
}

TEST(Svg, StyleSheetsCount) {
    const std::string sheet =
        "<style>/* two */ .wide, .x { stroke-width: 4; stroke-linecap: butt } line.wide { stroke-width: 2 }"
        "#gone { display: none } rect { display: inline }</style>";
    EXPECT_NEAR(area(sheet + "<path class='a wide' d='M5 9H15'/>"), 40, 1e-6);
    EXPECT_NEAR(area(sheet + "<line class='wide' x1='5' y1='5' x2='15' y2='5'/>"), 20, 1e-6) << "the more special";
    EXPECT_NEAR(area(sheet + "<line class='wide' style='stroke-width:1' x1='5' y1='5' x2='15' y2='5'/>"), 10, 1e-6);
    EXPECT_EQ(area(sheet + "<rect id='gone' width='4' height='4'/>"), 0);
    EXPECT_EQ(area("<g style='fill:red;display:none'><rect width='4' height='4'/></g>"), 0);
}

TEST(Svg, UsesAreDrawnWhereTheyStand) {
    const std::string rect = "<defs><rect id='r' width='2' height='3'/></defs>";
    EXPECT_NEAR(area(rect + "<use href='#r'/><use xlink:href='#r' x='10'/>"), 12, 1e-6);
    EXPECT_NEAR(read(rect + "<use href='#r' x='10' transform='scale(2)'/>").box.lo.x, 20, 1e-6);
    const std::string symbol = "<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>";
    EXPECT_EQ(area(symbol), 0);
    EXPECT_NEAR(area(symbol + "<use href='#s' width='4' height='2'/>"), 4, 1e-6);
    EXPECT_NEAR(area(symbol + "<use href='#s'/>"), 100, 1e-6);
    EXPECT_NEAR(area("<svg x='5' width='20' height='10' viewBox='0 0 2 1'><rect width='2' height='1'/></svg>"), 200,
                1e-6);
    EXPECT_EQ(read("<use href='#none'/>").warnings.size(), 1u);
    EXPECT_EQ(read("<g id='a'><use href='#a'/></g>").warnings, std::vector<std::string>{"SVG element 'a' uses itself"});
}

TEST(Svg, PagesFitTheirViewBox) {
    const std::string rect = "<rect width='10' height='20'/>";
    const auto box = [&](const std::string& aspect) {
        return read(rect, "width='100mm' height='100mm' viewBox='0 0 10 20' preserveAspectRatio='" + aspect + "'").box;
    };
    EXPECT_NEAR(box("").lo.x, 25, 1e-6);
    EXPECT_NEAR(box("").hi.x, 75, 1e-6);
    EXPECT_NEAR(box("xMinYMid meet").lo.x, 0, 1e-6);
    EXPECT_NEAR(box("xMaxYMin").hi.x, 100, 1e-6);
    EXPECT_NEAR(box("none").hi.x, 100, 1e-6);
    EXPECT_NEAR(box("xMidYMax slice").lo.y, 0, 1e-6);
    EXPECT_NEAR(box("xMidYMax slice").hi.y, 200, 1e-6);
    EXPECT_NEAR(read(rect, "width='100%' height='100%' viewBox='0 0 72 72'").box.hi.y, 25.4, 1e-6);
    EXPECT_NEAR(read("<rect width='1in' height='36'/>", "width='72' height='72'").area, 72 * 36, 1e-6)
        << "without a viewBox a unit is a millimeter";
}

/// As OpenSCAD takes them: width and height of a page where they have each unit, or none, or are not there.
TEST(Svg, SidesOfPages) {
    const auto box = [&](const std::string& head) {
        return read("<rect x='10' y='20' width='30' height='40'/>", head).box;
    };
    const auto near = [](const csg::Box& a, double x0, double y0, double x1, double y1) {
        EXPECT_NEAR(a.lo.x, x0, 1e-3);
        EXPECT_NEAR(a.lo.y, y0, 1e-3);
        EXPECT_NEAR(a.hi.x, x1, 1e-3);
        EXPECT_NEAR(a.hi.y, y1, 1e-3);
    };
    near(box(""), 10, -60, 40, -20);
    near(box("width='100' height='100'"), 10, -24.722, 40, 15.278);
    near(box("width='100px' height='100px' viewBox='0 0 100 100'"), 2.646, 10.583, 10.583, 21.167);
    near(box("width='10em' height='10em' viewBox='0 0 100 100'"), 10, 40, 40, 80);
    near(box("width='100mm' viewBox='0 0 200 100'"), 18.25, 14.111, 28.833, 28.222);
    near(box("height='100mm' viewBox='0 0 200 100'"), 3.528, 46.472, 14.111, 60.583);
    near(box("width='100mm' height='100mm' viewBox='-50 -50 100 100'"), 60, 90, 90, 130);
    near(box("width='50mm' height='100mm' viewBox='5 7 100 100' preserveAspectRatio='xMaxYMax slice'"), -45, 33, -15,
         73);
}

TEST(Svg, WhatIsLeftOutIsTold) {
    EXPECT_EQ(read("<text>A</text><text>B</text>").warnings.size(), 1u);
    csg::Import import;
    import.id = "a";
    EXPECT_NEAR(read("<g id='a'><rect width='2' height='2'/></g><rect x='9' width='5' height='5'/>", "", import).area,
                4, 1e-6);
    EXPECT_EQ(read("<rect width='5' height='5'/>", "", import).warnings.size(), 1u);
    const Read broken = read("<rect width='5' height='5'/><g>");
    ASSERT_EQ(broken.failures.size(), 1u);
    EXPECT_NE(broken.failures[0].find("in line 1"), std::string::npos) << broken.failures[0];
    EXPECT_NEAR(broken.area, 25, 1e-6) << "what came before";
}

}  // namespace
