// How wide lines are in a picture.
#pragma once

#include <vector>

#include "tests/edges/edge_points.h"

namespace edges {

/// Where a line was measured.
struct Width {
    glm::dvec2 at{0};  ///< As Point::at.
    double ink = 0;    ///< Integral of darkness across the line, in pixels.
};

/// Paints visible lines of a width, black on paper, and measures them at those true points about which there is nothing
/// but one straight line within some pixels.
[[nodiscard]] std::vector<Width> line_widths(const layers::HostStack& stack, const base::View& view,
                                             const std::vector<Point>& truth, float width);

}  // namespace edges
