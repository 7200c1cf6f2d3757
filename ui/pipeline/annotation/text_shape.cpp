#include "ui/pipeline/annotation/text_shape.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace ui {

namespace {

constexpr double kInterline = 1.7, kDescent = 0.3;  // Of capitals.

std::size_t characters_of(const std::string& utf8) {
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

TextShape text_shape(const std::string& text, double capitals, csg::solid::FontLibrary& fonts) {
    constexpr double kSize = 10;  // That of OpenSCAD's text(), with capitals as high.
    std::vector<csg::solid::Outline> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        csg::Text set;
        set.text = line;
        set.size = kSize;
        lines.push_back(csg::solid::text_outline(set, fonts));
    }
    const double scale = capitals / kSize;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (const auto& line : lines) {
        for (const auto& loop : line.loops) {
            for (const glm::dvec2& p : loop) {
                left = std::min(left, p.x);
                right = std::max(right, p.x);
            }
        }
    }
    TextShape shape;
    if (!(left <= right)) {
        return shape;
    }
    const double rows = static_cast<double>(lines.size());
    shape.size = {scale * (right - left), capitals * (1 + kDescent + (rows - 1) * kInterline)};
    double baseline = shape.size.y - capitals;
    for (auto& line : lines) {
        for (auto& loop : line.loops) {
            for (glm::dvec2& p : loop) {
                p = scale * (p - glm::dvec2(left, 0)) + glm::dvec2(0, baseline);
            }
            shape.outline.loops.push_back(std::move(loop));
        }
        baseline -= capitals * kInterline;
    }
    return shape;
}

std::string wrapped(const std::string& text, std::size_t characters) {
    std::istringstream words(text);
    std::string result, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && characters_of(line) + 1 + characters_of(word) > characters) {
            result += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + line;
}

}  // namespace ui
