// Measures of text and fonts, in model units.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace csg {

/// Of a text as it would be set (OpenSCAD's textmetrics()); all but `advance` is zero where it leaves no ink.
struct TextMetrics {
    glm::dvec2 position{0.0};  ///< Lower left corner of the box around the ink.
    glm::dvec2 size{0.0};      ///< Of that box.
    double ascent = 0;         ///< Of the highest glyph above the baseline.
    double descent = 0;        ///< Of the lowest; negative below the baseline.
    glm::dvec2 offset{0.0};    ///< Where the alignment puts the beginning of the baseline.
    glm::dvec2 advance{0.0};   ///< From the beginning to where a text after this one would begin.
};

/// Of a font at a size (OpenSCAD's fontmetrics()).
struct FontMetrics {
    double nominal_ascent = 0, nominal_descent = 0;  ///< Of most of the glyphs.
    double max_ascent = 0, max_descent = 0;          ///< Of all of them.
    double interline = 0;                            ///< From one baseline to the next.
    std::string family, style;
};

}  // namespace csg
