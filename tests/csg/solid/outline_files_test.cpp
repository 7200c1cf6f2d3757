// Drawings as files: what is written is read again, the same outline gives the same bytes.
#include <gtest/gtest.h>

#include "csg/solid/import_outline.h"
#include "csg/solid/outline_files.h"

namespace {

using namespace csg::solid;

/// A square with a hole, beside it a triangle that shares no grid with it.
Outline sample() {
    const Loop loops[] = {{{-10, -10}, {20, -10}, {20, 10.125}, {-10, 10.125}},
                          {{0, 0}, {0, 5}, {5, 5}, {5, 0}},
                          {{30, 0}, {30.1, 1.0 / 3}, {31, 1e-6}}};
    return clean(loops, FillRule::EvenOdd);
}

TEST(OutlineFiles, DxfIsReadAgain) {
    const Outline outline = sample();
    Remarks remarks;
    const Outline read = clean(read_dxf(encode_dxf(outline), {}, remarks), FillRule::EvenOdd);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
    EXPECT_EQ(read.corners(), outline.corners());
    EXPECT_EQ(bounds_of(read.loops), bounds_of(outline.loops));
    EXPECT_NEAR(read.area(), outline.area(), 1e-12 * outline.area());
}

TEST(OutlineFiles, SvgIsReadAgain) {
    const Outline outline = sample();
    Remarks remarks;
    const Outline read = read_svg(encode_svg(outline, {}), {}, remarks);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
    EXPECT_EQ(read.corners(), outline.corners());
    EXPECT_NEAR(read.area(), outline.area(), 1e-9 * outline.area());
    EXPECT_NEAR(bounds_of(read.loops).size().y, 20.125, 1e-9);
}

TEST(OutlineFiles, SvgIsPaintedAsAsked) {
    Paint paint;
    paint.fill = true;
    paint.fill_color = {255, 215, 0};
    paint.stroke = false;
    const std::string svg = encode_svg(sample(), paint);
    EXPECT_NE(svg.find("width=\"41mm\" height=\"20.125mm\" viewBox=\"-10 -10.125 41 20.125\""), std::string::npos)
        << svg;
    EXPECT_NE(svg.find("fill=\"#ffd700\" stroke=\"none\""), std::string::npos);
}

TEST(OutlineFiles, PdfIsInTrueSizeInTheMiddle) {
    PdfPage page;
    page.scale = false;
    const std::string pdf = encode_pdf(sample(), page);
    EXPECT_TRUE(pdf.starts_with("%PDF-1.4\n"));
    EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
    EXPECT_NE(pdf.find("/MediaBox [0 0 595.276 841.890]"), std::string::npos);
    EXPECT_NE(pdf.find("\n2.83465 0 0 2.83465 0 0 cm\n"), std::string::npos);  // millimeters
    // The box is -10…31 by -10…10.125: its lower left corner is at 105 - 20.5, 148.5 - 10.0625.
    EXPECT_NE(pdf.find("\n84.5 138.4375 "), std::string::npos) << pdf;
    EXPECT_EQ(pdf.find("Date"), std::string::npos);
    EXPECT_EQ(pdf, encode_pdf(sample(), page));
}

/// The table of a PDF leads to its objects, or readers have to repair the file.
TEST(OutlineFiles, PdfTableLeadsToItsObjects) {
    PdfPage page;
    page.grid = true;
    page.file_name = "a (b) \\ \xC3\xA4.scad";
    page.title = "\xC3\xA4 \xF0\x9F\x99\x82";
    const std::string pdf = encode_pdf(sample(), page);
    const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
    ASSERT_EQ(pdf.substr(table, 5), "xref\n");
    std::size_t at = pdf.find("f \n", table) + 3;
    for (int object = 1; object <= 6; ++object, at += 20) {
        EXPECT_EQ(pdf.substr(std::stoul(pdf.substr(at, 10)), 7), std::to_string(object) + " 0 obj");
    }
    EXPECT_NE(pdf.find("(a \\(b\\) \\\\ ?.scad) Tj"), std::string::npos);
    EXPECT_NE(pdf.find("/Title <FEFF00E40020D83DDE42>"), std::string::npos);
    // The stream is as long as it says.
    const std::size_t length = std::stoul(pdf.substr(pdf.find("/Length ") + 8)), begin = pdf.find("stream\n") + 7;
    EXPECT_EQ(pdf.substr(begin + length, 9), "endstream");
}

TEST(OutlineFiles, APageThatIsTooSmallIsKnown) {
    const Loop wide[] = {{{0, 0}, {200, 0}, {200, 50}, {0, 50}}};
    const Outline outline = clean(wide, FillRule::EvenOdd);
    PdfPage page;
    EXPECT_TRUE(beyond_page(outline, page));
    page.turn = PageTurn::Auto;
    EXPECT_FALSE(beyond_page(outline, page));
    EXPECT_NE(encode_pdf(outline, page).find("/MediaBox [0 0 841.890 595.276]"), std::string::npos);
}

}  // namespace
