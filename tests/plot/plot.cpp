#include "tests/plot/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plot {

namespace {

constexpr std::array<const char*, 10> kColors{"#1f4e9e", "#c0392b", "#2e8b57", "#8e44ad", "#d68910",
                                              "#444444", "#17a2b8", "#e75480", "#7a5230", "#8aa000"};
constexpr int kLeft = 62, kRight = 14, kTop = 30;
constexpr int kAxisHeight = 32, kLegendLine = 14;  ///< Below the axis: its numbers and label, and names of series.

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return result;
}

/// Values to the part of an axis, 0 to 1.
class Scale {
  public:
    Scale(const Axis& axis, std::vector<double> values) : axis_(axis) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const double v : values) {
            if (!axis.logarithmic || v > 0) {
                least = std::min(least, v);
                most = std::max(most, v);
            }
        }
        if (!(least <= most)) {
            least = axis.logarithmic ? 0.1 : 0;
            most = 1;
        }
        if (axis.logarithmic) {
            lo_ = std::floor(std::log10(least));
            hi_ = std::max(std::ceil(std::log10(most)), lo_ + 1);
            // Room for what is 0.
            lo_ -= std::any_of(values.begin(), values.end(), [](double v) { return v <= 0; }) ? 1 : 0;
        } else {
            lo_ = std::min(least, 0.0);
            hi_ = most > lo_ ? most : lo_ + 1;
        }
    }
    [[nodiscard]] double at(double value) const {
        const double v = !axis_.logarithmic ? value : value > 0 ? std::log10(value) : lo_;
        const double t = std::clamp((v - lo_) / (hi_ - lo_), 0.0, 1.0);
        return axis_.descending ? 1 - t : t;
    }
    /// Places with their text.
    [[nodiscard]] std::vector<std::pair<double, std::string>> ticks() const {
        std::vector<std::pair<double, std::string>> result;
        if (axis_.logarithmic) {
            const int step = std::max(1, static_cast<int>(std::ceil((hi_ - lo_) / 6)));
            for (int e = static_cast<int>(lo_); e <= static_cast<int>(hi_); e += step) {
                result.emplace_back(std::pow(10.0, e), e >= -2 && e <= 3 ? fmt::format("{:g}", std::pow(10.0, e))
                                                                         : fmt::format("1e{}", e));
            }
            return result;
        }
        for (int i = 0; i <= 4; ++i) {
            const double v = lo_ + (hi_ - lo_) * i / 4;
            result.emplace_back(v, fmt::format("{:.3g}", v));
        }
        return result;
    }

  private:
    const Axis& axis_;
    double lo_ = 0, hi_ = 1;
};

/// Where a name stands in the legend.
struct LegendPlace {
    int x, line;
};

/// Names of series one after the other, as many in a line as there is room for.
std::vector<LegendPlace> legend(const Plot& plot) {
    constexpr int kLetter = 6, kGap = 16;  // About, at this size.
    std::vector<LegendPlace> places;
    int x = kLeft, line = 0;
    for (const Series& s : plot.series) {
        const int width = kLetter * static_cast<int>(s.name.size());
        if (x > kLeft && x + width > plot.width - kRight) {
            x = kLeft;
            ++line;
        }
        places.push_back({x, line});
        x += width + kGap;
    }
    return places;
}

}  // namespace

std::string to_svg(const Plot& plot) {
    std::vector<double> xs, ys;
    for (const Series& s : plot.series) {
        for (const auto& [x, y] : s.points) {
            xs.push_back(x);
            ys.push_back(y);
        }
    }
    const Scale x_scale(plot.x, xs), y_scale(plot.y, ys);
    const std::vector<LegendPlace> names = legend(plot);
    const int lines = names.empty() ? 1 : names.back().line + 1;
    const int bottom = kAxisHeight + kLegendLine * lines;
    const double w = plot.width - kLeft - kRight, h = plot.height - kTop - bottom;
    const auto px = [&](double x) { return kLeft + w * x_scale.at(x); };
    const auto py = [&](double y) { return kTop + h * (1 - y_scale.at(y)); };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
        "<text x=\"{2}\" y=\"16\" font-size=\"13\">{3}</text>\n",
        plot.width, plot.height, kLeft, escaped(plot.title));
    for (const auto& [value, text] : x_scale.ticks()) {
        svg += fmt::format(
            "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}"
            "</text>\n",
            px(value), kTop, plot.height - bottom, plot.height - bottom + 14, text);
    }
    for (const auto& [value, text] : y_scale.ticks()) {
        svg += fmt::format(
            "<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
            "text-anchor=\"end\">{5}</text>\n",
            py(value), kLeft, plot.width - kRight, kLeft - 5, py(value) + 4, text);
    }
    svg += fmt::format(
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n<text transform=\"translate(12 {}) rotate(-90)\" "
        "text-anchor=\"middle\">{}</text>\n",
        kLeft + w / 2, plot.height - bottom + 30, escaped(plot.x.label), kTop + h / 2, escaped(plot.y.label));
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& s = plot.series[i];
        const char* color = kColors[i % kColors.size()];
        std::string path;
        for (std::size_t k = 0; k < s.points.size(); ++k) {
            const auto& [x, y] = s.points[k];
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px(x), py(y));
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>", px(x), py(y), color);
            if (k < s.labels.size()) {
                svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"8\" fill=\"{}\">{}</text>", px(x) + 3,
                                   py(y) - 3, color, escaped(s.labels[k]));
            }
        }
        if (plot.joined && !path.empty()) {
            svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>", path, color);
        }
        svg += fmt::format("\n<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", names[i].x,
                           plot.height - 4 - kLegendLine * (lines - 1 - names[i].line), color, escaped(s.name));
    }
    return svg + "</svg>\n";
}

}  // namespace plot
