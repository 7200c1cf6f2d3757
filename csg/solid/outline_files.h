// Outlines as drawings: SVG, DXF and PDF. The same outline gives the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "csg/solid/outline.h"

namespace csg::solid {

enum class DrawingFormat : std::uint8_t { Svg, Dxf, Pdf };

using Rgb8 = std::array<std::uint8_t, 3>;  ///< sRGB.

/// How a region is painted. One unit of the model is one millimeter.
struct Paint {
    bool fill = false;
    Rgb8 fill_color{0, 0, 0};
    bool stroke = true;
    Rgb8 stroke_color{0, 0, 0};
    double stroke_width = 0.35;  ///< Millimeters.
};

enum class PageTurn : std::uint8_t { Portrait, Landscape, Auto };

/// A sheet that is printed in true size, and what is on it beside the drawing.
struct PdfPage {
    Paint paint;
    glm::dvec2 paper{210, 297};  ///< Millimeters, upright.
    PageTurn turn = PageTurn::Portrait;
    bool scale = true;          ///< Rulers at the left and the lower edge, in the model's coordinates.
    bool scale_message = true;  ///< One line that says what the rulers are for.
    bool grid = false;
    double grid_size = 10;  ///< Millimeters.
    std::string file_name;  ///< Printed below the drawing; empty: none.
    // Properties of the document (UTF-8); empty ones are left out.
    std::string title, author, subject, keywords;
};

/// One path, even-odd, in millimeters; y is turned, since SVG counts it downwards.
[[nodiscard]] std::string encode_svg(const Outline& outline, const Paint& paint);

/// Every side as a LINE on layer 0 (release 12), which any program reads.
[[nodiscard]] std::string encode_dxf(const Outline& outline);

/// One page with the middle of the drawing in its middle (PDF 1.4). No date, and only fonts that every reader has, so
/// that the bytes depend on nothing but the arguments.
[[nodiscard]] std::string encode_pdf(const Outline& outline, const PdfPage& page);

/// Is the drawing larger than what the page has between its margins?
[[nodiscard]] bool beyond_page(const Outline& outline, const PdfPage& page);

}  // namespace csg::solid
