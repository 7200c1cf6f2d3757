#include "ui/pipeline/picture/storyboard.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ui/pipeline/annotation/text_shape.h"

namespace ui {

namespace {

constexpr int kGap = 8, kLeastPanel = 32;

void mix(base::Image& image, int x, int y, const glm::vec3& color, double share) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height || share <= 0) {
        return;
    }
    std::uint8_t* const to = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                              static_cast<std::size_t>(x))];
    for (int c = 0; c < 3; ++c) {
        const double mixed = to[c] + std::min(share, 1.0) * (255.0 * color[c] - to[c]);
        to[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    to[3] = static_cast<std::uint8_t>(std::lround(to[3] + std::min(share, 1.0) * (255.0 - to[3])));
}

/// Fills a region whose y points up from `origin`; rows of pixels by four lines each, exact along them.
void fill(base::Image& image, const csg::solid::Outline& outline, const glm::dvec2& origin, const glm::vec3& color) {
    constexpr int kLines = 4;
    const csg::Box box = csg::solid::bounds_of(outline.loops);
    if (outline.empty()) {
        return;
    }
    const int top = static_cast<int>(std::floor(origin.y - box.hi.y)),
              bottom = static_cast<int>(std::ceil(origin.y - box.lo.y));
    const int left = static_cast<int>(std::floor(origin.x + box.lo.x)),
              right = static_cast<int>(std::ceil(origin.x + box.hi.x));
    for (int y = top; y < bottom; ++y) {
        std::vector<double> covered(static_cast<std::size_t>(right - left) + 1, 0);
        for (int line = 0; line < kLines; ++line) {
            const double at = origin.y - (y + (line + 0.5) / kLines);
            std::vector<double> crossings;
            for (const csg::solid::Loop& loop : outline.loops) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
                    if ((a.y <= at) != (b.y <= at)) {
                        crossings.push_back(origin.x + a.x + (at - a.y) / (b.y - a.y) * (b.x - a.x));
                    }
                }
            }
            std::sort(crossings.begin(), crossings.end());
            for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
                for (int x = static_cast<int>(std::floor(crossings[i])); x < crossings[i + 1]; ++x) {
                    const double share = std::min(crossings[i + 1], x + 1.0) - std::max(crossings[i], double{1} * x);
                    covered[static_cast<std::size_t>(std::clamp(x - left, 0, right - left))] += share / kLines;
                }
            }
        }
        for (int x = left; x <= right; ++x) {
            mix(image, x, y, color, covered[static_cast<std::size_t>(x - left)]);
        }
    }
}

}  // namespace

double draw_text(base::Image& image, const std::string& text, const glm::dvec2& corner, double capitals,
                 const glm::vec3& color, csg::solid::FontLibrary& fonts) {
    const TextShape shape = text_shape(text, capitals, fonts);
    fill(image, shape.outline, corner + glm::dvec2(0, shape.size.y - capitals), color);
    return shape.size.x;
}

SheetLayout sheet_layout(glm::ivec2 size, int count, double aspect) {
    SheetLayout best;
    double largest = 0;
    int columns = 1;
    for (int across = 1; across <= count; ++across) {
        const int down = (count + across - 1) / across;
        SheetLayout layout;
        const glm::ivec2 cell((size.x - kGap * (across + 1)) / across, (size.y - kGap * (down + 1)) / down);
        layout.caption = std::clamp(cell.y / 8, 12, 40);
        layout.panel = {cell.x, cell.y - layout.caption};
        const double large = std::min(double{1} * layout.panel.x, aspect * layout.panel.y);
        if (large > largest) {
            largest = large;
            columns = across;
            best = layout;
        }
    }
    if (std::min(best.panel.x, best.panel.y) < kLeastPanel) {
        throw std::runtime_error("the panels would be too small; make the picture larger (--imgsize)");
    }
    for (int i = 0; i < count; ++i) {
        const glm::ivec2 at(i % columns, i / columns);
        best.corners.push_back(kGap + at * (best.panel + glm::ivec2(kGap, kGap + best.caption)));
    }
    return best;
}

base::Image draw_sheet(glm::ivec2 size, const SheetLayout& layout, const std::vector<std::string>& captions,
                       const npr::ColorScheme& scheme, const std::function<base::Image(std::size_t)>& render) {
    base::Image sheet{
        size.x, size.y,
        std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))};
    const glm::vec3& ground = scheme.background;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            mix(sheet, x, y, ground, 1);
        }
    }
    const glm::vec3 ink(ground.r + ground.g + ground.b > 1.5F ? 0.1F : 0.95F);
    csg::solid::FontLibrary fonts;
    // As large as the strips have room for, all alike.
    double capitals = 0.45 * layout.caption;
    for (const std::string& caption : captions) {
        const double width = text_shape(caption, capitals, fonts).size.x;
        capitals *= std::min(1.0, layout.panel.x / std::max(width, 1.0));
    }
    for (std::size_t i = 0; i < layout.corners.size(); ++i) {
        const glm::ivec2 corner = layout.corners[i];
        const base::Image panel = render(i);
        for (int y = 0; y < std::min(panel.height, layout.panel.y); ++y) {
            std::copy_n(panel.pixel(0, y), 4 * std::min(panel.width, layout.panel.x),
                        sheet.rgba.begin() + 4 * (std::ptrdiff_t{corner.y + y} * size.x + corner.x));
        }
        for (int x = -1; x <= layout.panel.x; ++x) {
            mix(sheet, corner.x + x, corner.y - 1, ink, 1);
            mix(sheet, corner.x + x, corner.y + layout.panel.y, ink, 1);
        }
        for (int y = 0; y < layout.panel.y; ++y) {
            mix(sheet, corner.x - 1, corner.y + y, ink, 1);
            mix(sheet, corner.x + layout.panel.x, corner.y + y, ink, 1);
        }
        draw_text(sheet, captions[i],
                  glm::dvec2(corner) + glm::dvec2(0, layout.panel.y + 0.25 * layout.caption + capitals), capitals, ink,
                  fonts);
    }
    return sheet;
}

}  // namespace ui
