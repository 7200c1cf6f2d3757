// Simple line plots as SVG, for documents.
#pragma once

#include <string>
#include <vector>

namespace plot {

struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< In the order in which they are joined.
    std::vector<std::string> labels{};              ///< Of the points, small; or none.
};

struct Axis {
    std::string label;
    bool logarithmic = false;  ///< Values of 0 or less then stand at the lower end.
    bool descending = false;   ///< The largest value first.
};

struct Plot {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
    bool joined = true;  ///< False: points only.
    int width = 420, height = 260;
};

/// A whole SVG file.
[[nodiscard]] std::string to_svg(const Plot& plot);

}  // namespace plot
