#include "ui/pipeline/picture/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace ui {

namespace {

constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

struct Glyph {
    char character;
    std::array<std::uint8_t, kGlyphHeight> rows;  ///< From the top; the leftmost pixel is bit 4.
};
constexpr std::array kGlyphs{
    Glyph{'0', {14, 17, 19, 21, 25, 17, 14}}, Glyph{'1', {4, 12, 4, 4, 4, 4, 14}},
    Glyph{'2', {14, 17, 1, 2, 4, 8, 31}},     Glyph{'3', {31, 2, 4, 2, 1, 17, 14}},
    Glyph{'4', {2, 6, 10, 18, 31, 2, 2}},     Glyph{'5', {31, 16, 30, 1, 1, 17, 14}},
    Glyph{'6', {6, 8, 16, 30, 17, 17, 14}},   Glyph{'7', {31, 1, 2, 4, 8, 8, 8}},
    Glyph{'8', {14, 17, 17, 14, 17, 17, 14}}, Glyph{'9', {14, 17, 17, 15, 1, 2, 12}},
    Glyph{'.', {0, 0, 0, 0, 0, 12, 12}},      Glyph{'m', {0, 0, 26, 21, 21, 21, 21}},
    Glyph{'e', {0, 0, 14, 17, 31, 16, 14}},   Glyph{'-', {0, 0, 0, 31, 0, 0, 0}},
    Glyph{'+', {0, 4, 4, 31, 4, 4, 0}},       Glyph{' ', {}},
};

class LegendPainter {
  public:
    LegendPainter(base::Image& image, int scale) : image_(image), scale_(scale) {}

    void fill(glm::ivec2 lo, glm::ivec2 size, const glm::vec3& color) {
        for (int y = std::max(lo.y, 0); y < std::min(lo.y + size.y, image_.height); ++y) {
            for (int x = std::max(lo.x, 0); x < std::min(lo.x + size.x, image_.width); ++x) {
                std::uint8_t* to =
                    &image_.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                                      static_cast<std::size_t>(x))];
                for (int c = 0; c < 3; ++c) {
                    to[c] = static_cast<std::uint8_t>(std::lround(255 * color[c]));
                }
                to[3] = 255;
            }
        }
    }

    void write(std::string_view text, glm::ivec2 at, const glm::vec3& color) {
        for (const char character : text) {
            const auto* glyph =
                std::find_if(kGlyphs.begin(), kGlyphs.end(), [&](const Glyph& g) { return g.character == character; });
            for (int y = 0; glyph != kGlyphs.end() && y < kGlyphHeight; ++y) {
                for (int x = 0; x < kGlyphWidth; ++x) {
                    if ((glyph->rows[static_cast<std::size_t>(y)] >> (kGlyphWidth - 1 - x) & 1) != 0) {
                        fill(at + scale_ * glm::ivec2(x, y), glm::ivec2(scale_), color);
                    }
                }
            }
            at.x += (kGlyphWidth + 1) * scale_;
        }
    }

  private:
    base::Image& image_;
    int scale_;
};

}  // namespace

double legend_step(double full) {
    const double decade = std::pow(10.0, std::floor(std::log10(full / 5)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade * 5 >= full * (1 - 1e-9)) {
            return factor * decade;
        }
    }
    return 10 * decade;
}

double round_up(double thickness) {
    const double unit = std::pow(10.0, std::floor(std::log10(thickness)) - 1);
    return std::ceil(thickness / unit * (1 - 1e-9)) * unit;
}

void draw_ring(base::Image& image, const glm::dvec2& at, std::string_view text, int lower) {
    constexpr int kTallOfOne = 320;
    const int scale = std::max(1, std::min(image.width, image.height) / kTallOfOne);
    const double radius = 7 * scale;
    const glm::vec3 ink(0), paper(1);
    LegendPainter canvas(image, scale);
    const glm::ivec2 middle(glm::floor(at));
    const int reach = static_cast<int>(radius) + 2 * scale;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            const double off = std::abs(std::hypot(x, y) - radius);
            if (off < 0.75 * scale) {
                canvas.fill(middle + glm::ivec2(x, y), glm::ivec2(1), ink);
            } else if (off < 1.5 * scale) {
                canvas.fill(middle + glm::ivec2(x, y), glm::ivec2(1), paper);
            }
        }
    }
    const glm::ivec2 size((static_cast<int>(text.size()) * (kGlyphWidth + 1) + 1) * scale, (kGlyphHeight + 2) * scale);
    const bool left = middle.x + reach + size.x > image.width;
    const glm::ivec2 corner(left ? middle.x - reach - size.x : middle.x + reach,
                            std::clamp(middle.y - size.y / 2 + lower * size.y, 0, std::max(0, image.height - size.y)));
    canvas.fill(corner, size, paper);
    canvas.write(text, corner + scale, ink);
}

void draw_legend(base::Image& image, double full, const std::function<glm::vec3(float share)>& tone) {
    draw_legend(image, full, tone, tone(0));
}

void draw_legend(base::Image& image, double full, const std::function<glm::vec3(float share)>& tone,
                 const glm::vec3& ground) {
    constexpr int kSmallest = 96, kTallOfOne = 320;
    if (std::min(image.width, image.height) < kSmallest || !(full > 0)) {
        return;
    }
    const int scale = std::max(1, std::min(image.width, image.height) / kTallOfOne);
    const int margin = 6 * scale, width = 8 * scale, height = image.height * 2 / 5;
    const glm::ivec2 lo(margin, image.height - margin - height);
    const auto luminance = [](const glm::vec3& c) { return c.r + c.g + c.b; };
    const glm::vec3 ink(luminance(ground) > 1.5F ? 0.0F : 1.0F);
    LegendPainter canvas(image, scale);
    canvas.fill(lo - scale, glm::ivec2(width, height) + 2 * scale, ink);
    for (int y = 0; y < height; ++y) {
        const float share = (static_cast<float>(height - y) - 0.5F) / static_cast<float>(height);
        canvas.fill({lo.x, lo.y + y}, {width, 1}, tone(share));
    }
    const double step = legend_step(full);
    for (int i = 0; i * step <= full * (1 + 1e-9); ++i) {
        const int y = lo.y + height - static_cast<int>(std::lround(i * step / full * height));
        canvas.fill({lo.x + width, y - scale / 2}, {3 * scale, scale}, ink);
        const std::string number = fmt::format("{:g}{}", i * step, i == 0 ? " mm" : "");
        canvas.write(
            number,
            {lo.x + width + 5 * scale, std::min(y - kGlyphHeight * scale / 2, image.height - kGlyphHeight * scale)},
            ink);
    }
}

int bar_strip(glm::ivec2 size) {
    return (kGlyphHeight + 14) * std::max(1, std::min(size.x, size.y) / 320);
}

void draw_scale_bar(base::Image& image, double pixels_per_millimeter, const glm::vec3& ink) {
    constexpr int kTallOfOne = 320;
    const int scale = std::max(1, std::min(image.width, image.height) / kTallOfOne);
    // Steps of a range are a fifth of it or more: this one is a tenth of the width to a quarter.
    const double length = legend_step(image.width / pixels_per_millimeter / 2);
    const int pixels = static_cast<int>(std::lround(length * pixels_per_millimeter));
    const glm::ivec2 lo(6 * scale, image.height - 8 * scale);
    LegendPainter canvas(image, scale);
    canvas.fill(lo, {pixels, scale}, ink);
    for (const int end : {0, pixels - scale}) {
        canvas.fill(lo + glm::ivec2(end, -2 * scale), {scale, 5 * scale}, ink);
    }
    canvas.write(fmt::format("{:g} mm", length), lo - glm::ivec2(0, (kGlyphHeight + 4) * scale), ink);
}

}  // namespace ui
