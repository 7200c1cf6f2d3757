// The `d` attribute of SVG paths and the `transform` attribute.
#pragma once

#include <string_view>
#include <vector>

#include "csg/solid/outline.h"

namespace csg::solid {

struct SvgSubpath {
    Loop points;
    bool closed = false;
};

/// Do the ends meet, as far as OpenSCAD looks?
[[nodiscard]] bool is_closed(const Loop& points);

/// In the path's own units; curves become lines, `around` for a whole turn of an arc. What follows a mistake is left
/// out, as SVG asks.
[[nodiscard]] std::vector<SvgSubpath> read_svg_path(std::string_view text, int around);

/// The product of the transforms in the list.
[[nodiscard]] glm::dmat4 read_svg_transform(std::string_view text);

/// The numbers in a list, separated by blanks or commas.
[[nodiscard]] std::vector<double> read_svg_numbers(std::string_view text);

}  // namespace csg::solid
