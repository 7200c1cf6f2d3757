// How wide lines are in a picture.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/edges/edge_points.h"

namespace edges {

/// Where a line was measured.
struct Width {
    glm::dvec2 at{0};  ///< As Point::at.
    double ink = 0;    ///< Integral of darkness across the line, in pixels.
    Kind kind = Kind::Silhouette;
};

/// A picture of lines that is measured: a style with its settings, whose ground and ink have these brightnesses in the
/// red channel (sRGB, 0 to 1).
struct Drawing {
    std::string_view style;
    std::map<std::string, std::string> settings;
    double ground = 1, ink = 0;
};
/// Visible lines of a width, black on paper.
[[nodiscard]] Drawing black_on_paper(double width);

/// The picture with one sample a pixel, rows from bottom to top: linear light.
[[nodiscard]] std::vector<glm::vec4> painted(const layers::HostStack& stack, const base::View& view,
                                             const Drawing& drawing, double dots_per_inch = 0);

/// Paints the picture with one sample a pixel, and measures lines at those true points, hidden or not, about which
/// there is nothing but one line within some pixels, hardly bent.
[[nodiscard]] std::vector<Width> line_widths(const layers::HostStack& stack, const base::View& view,
                                             const std::vector<Point>& truth, const Drawing& drawing,
                                             bool hidden = false);

}  // namespace edges
