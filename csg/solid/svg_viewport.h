// Lengths of SVG, and how a viewBox fits into a rectangle.
#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include "csg/solid/svg_document.h"

namespace csg::solid {

/// A number with a unit: as user units where there is none (px is one). A percentage counts of `whole`; millimeters and
/// the like are `dots_per_inch` user units an inch. 0 where there is no number.
[[nodiscard]] double svg_length(std::string_view text, double dots_per_inch, double whole = 0);

/// A transform into a rectangle of `size` at the origin: from the element's viewBox, placed by its preserveAspectRatio
/// (xMidYMid meet where there is none). Where there is no viewBox, nothing moves.
[[nodiscard]] glm::dmat4 svg_fit(const SvgElement& element, const glm::dvec2& size);

/// Of the viewBox; 0 where there is none.
[[nodiscard]] glm::dvec2 svg_view_size(const SvgElement& element);

/// Of the page: user units to millimeters, y up from the page's lower edge, by OpenSCAD's rules. Without a viewBox a
/// user unit is a millimeter. With one it fits into the page, whose sides count in user units of 25.4 / `dots_per_inch`
/// where they have no unit or are percentages of the viewBox or not given, in pixels of a 96th inch where they are px.
/// The viewBox's corner counts upwards along y.
[[nodiscard]] glm::dmat4 svg_page(const SvgElement& root, double dots_per_inch);

}  // namespace csg::solid
