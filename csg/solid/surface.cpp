// Height maps.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "csg/solid/extrude.h"
#include "csg/solid/file_text.h"
#include "csg/solid/files.h"
#include "csg/solid/png_samples.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostSurfaceBytes = std::size_t{1} << 28;
constexpr std::size_t kMostSamples = std::size_t{1} << 21;

/// Rows from the front (small y) to the back.
struct Heights {
    std::size_t columns = 0, rows = 0;
    std::vector<double> values;
    double bottom = 0;

    [[nodiscard]] double at(std::size_t x, std::size_t y) const { return values[y * columns + x]; }
};

/// Lines of numbers; the first line is the front. Short lines are filled with zeros.
Heights read_table(std::string_view text, std::vector<std::string>& warnings) {
    std::vector<std::vector<double>> lines;
    std::size_t columns = 0;
    std::size_t samples = 0;
    double least = std::numeric_limits<double>::infinity();
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        Words words(line, true);
        std::vector<double> numbers;
        while (!words.at_end()) {
            const std::string_view word = words.next();
            const auto number = to_number(word);
            if (!number) {
                warnings.push_back(fmt::format("Illegal value '{:.40}' in surface file", word));
                return {};
            }
            numbers.push_back(*number);
            least = std::min(least, *number);
        }
        if (numbers.empty()) {
            continue;
        }
        columns = std::max(columns, numbers.size());
        samples += numbers.size();
        lines.push_back(std::move(numbers));
        if (columns * lines.size() > kMostSamples || samples > kMostSamples) {
            warnings.push_back(fmt::format("surface file holds more than {} numbers; it is left out", kMostSamples));
            return {};
        }
    }
    Heights heights{columns, lines.size(), std::vector<double>(columns * lines.size(), 0.0), std::min(least - 1, 0.0)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::copy(lines[i].begin(), lines[i].end(), heights.values.begin() + static_cast<std::ptrdiff_t>(i * columns));
    }
    return heights;
}

/// Luminance, 0 to 100; inverted, less the 255th part of that, as in OpenSCAD: white is at -100 + 100/255.
Heights read_picture(const std::string& text, bool invert, std::vector<std::string>& warnings) {
    const PngSamples picture = read_png(text, kMostSamples);
    if (!picture.problem.empty()) {
        warnings.push_back(picture.problem);
        return {};
    }
    Heights heights{picture.columns, picture.rows, {}, 0};
    heights.values.resize(heights.columns * heights.rows);
    for (std::size_t y = 0; y < heights.rows; ++y) {
        for (std::size_t x = 0; x < heights.columns; ++x) {
            const double* p = &picture.values[(y * heights.columns + x) * 3];
            const double light = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
            heights.values[(heights.rows - 1 - y) * heights.columns + x] = 100 * (invert ? 1.0 / 255 - light : light);
        }
    }
    heights.bottom = *std::min_element(heights.values.begin(), heights.values.end()) - 1;
    return heights;
}

/// Each cell is four triangles about its middle; the bottom lies 1 below the lowest value, of a table not above 0, as
/// in OpenSCAD.
void build(const Heights& heights, bool center, Solid& solid) {
    const std::size_t columns = heights.columns, rows = heights.rows;
    const double bottom = heights.bottom;
    const double ox = center ? -static_cast<double>(columns - 1) / 2 : 0;
    const double oy = center ? -static_cast<double>(rows - 1) / 2 : 0;
    const auto index = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
    for (std::size_t y = 0; y < rows; ++y) {
        for (std::size_t x = 0; x < columns; ++x) {
            solid.points.emplace_back(ox + static_cast<double>(x), oy + static_cast<double>(y), heights.at(x, y));
        }
    }
    for (std::size_t y = 0; y + 1 < rows; ++y) {
        for (std::size_t x = 0; x + 1 < columns; ++x) {
            const double middle =
                (heights.at(x, y) + heights.at(x + 1, y) + heights.at(x, y + 1) + heights.at(x + 1, y + 1)) / 4;
            const std::uint32_t m = index(solid.points.size()), a = index(y * columns + x), b = a + 1,
                                d = index((y + 1) * columns + x), c = d + 1;
            solid.points.emplace_back(ox + static_cast<double>(x) + 0.5, oy + static_cast<double>(y) + 0.5, middle);
            for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)}) {
                solid.triangles.emplace_back(p, q, m);
            }
        }
    }
    // The border, counter-clockwise seen from above.
    std::vector<std::uint32_t> border;
    for (std::size_t x = 0; x + 1 < columns; ++x) {
        border.push_back(index(x));
    }
    for (std::size_t y = 0; y + 1 < rows; ++y) {
        border.push_back(index(y * columns + columns - 1));
    }
    for (std::size_t x = columns - 1; x > 0; --x) {
        border.push_back(index((rows - 1) * columns + x));
    }
    for (std::size_t y = rows - 1; y > 0; --y) {
        border.push_back(index(y * columns));
    }
    const std::uint32_t below = index(solid.points.size()), n = index(border.size());
    for (const std::uint32_t i : border) {
        solid.points.emplace_back(solid.points[i].x, solid.points[i].y, bottom);
    }
    const std::uint32_t middle = index(solid.points.size());
    solid.points.emplace_back(ox + static_cast<double>(columns - 1) / 2, oy + static_cast<double>(rows - 1) / 2,
                              bottom);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        solid.triangles.emplace_back(below + i, below + j, border[j]);
        solid.triangles.emplace_back(below + i, border[j], border[i]);
        solid.triangles.emplace_back(middle, below + j, below + i);
    }
}

}  // namespace

std::shared_ptr<Solid> surface_solid(const Surface& surface) {
    auto solid = std::make_shared<Solid>();
    const auto text = read_file(surface.file.path, kMostSurfaceBytes, solid->failures);
    if (!text) {
        return solid;
    }
    const bool picture = text->size() > 8 && std::memcmp(text->data(), "\x89PNG\r\n\x1a\n", 8) == 0;
    const Heights heights =
        picture ? read_picture(*text, surface.invert, solid->failures) : read_table(*text, solid->failures);
    if (heights.columns < 2 || heights.rows < 2) {
        if (solid->failures.empty()) {
            solid->failures.emplace_back("surface file holds less than two rows of two numbers");
        }
        return solid;
    }
    build(heights, surface.center, *solid);
    finish(*solid);
    solid->simple = true;
    return solid;
}

}  // namespace csg::solid
