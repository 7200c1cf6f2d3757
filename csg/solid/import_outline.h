// Outlines from the texts of files.
#pragma once

#include <string_view>
#include <vector>

#include "csg/solid/outline.h"
#include "csg/solid/remarks.h"

namespace csg::solid {

/// The closed loops of the layer (of all, where none is named); lines and arcs that meet end to end are joined.
[[nodiscard]] std::vector<Loop> read_dxf(std::string_view text, const Import& import, Remarks& remarks);

/// In millimeters, y up: paths and basic shapes with their transforms.
[[nodiscard]] Outline read_svg(std::string_view text, const Import& import, Remarks& remarks);

/// Points along an ellipse from `from` to `to` degrees, the first left out: `axes` are its half axes.
void add_arc(Loop& loop, const glm::dvec2& center, const glm::dvec2& first_axis, const glm::dvec2& second_axis,
             double from, double to, int around);

}  // namespace csg::solid
