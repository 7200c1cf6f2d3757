#include "tests/bench/worst_pixels.h"

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

constexpr int kZoom = 7, kGap = 6, kCell = WorstPixel::kSide * kZoom;

void fill(base::Image& image, glm::ivec2 lo, int side, const std::uint8_t* color) {
    for (int y = lo.y; y < lo.y + side; ++y) {
        for (int x = lo.x; x < lo.x + side; ++x) {
            std::copy_n(color, 3, &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)]);
        }
    }
}

void frame(base::Image& image, glm::ivec2 lo, int side) {
    constexpr std::uint8_t kBlack[3] = {0, 0, 0}, kWhite[3] = {255, 255, 255};
    for (int i = -1; i <= side; ++i) {
        for (const glm::ivec2 at : {glm::ivec2(i, -1), glm::ivec2(i, side), glm::ivec2(-1, i), glm::ivec2(side, i)}) {
            fill(image, lo + at, 1, (i & 1) != 0 ? kBlack : kWhite);
        }
    }
}

void draw(base::Image& image, glm::ivec2 lo, const std::vector<std::uint8_t>& pixels) {
    for (int y = 0; y < WorstPixel::kSide; ++y) {
        for (int x = 0; x < WorstPixel::kSide; ++x) {
            fill(image, lo + kZoom * glm::ivec2(x, y), kZoom,
                 &pixels[3 * static_cast<std::size_t>(y * WorstPixel::kSide + x)]);
        }
    }
    frame(image, lo + kZoom * (WorstPixel::kSide / 2), kZoom);
}

}  // namespace

WorstPixel worst_pixel(const analytic::Truth& truth, const base::Image& image, const analytic::Error& error) {
    WorstPixel result;
    for (int y = -WorstPixel::kSide / 2; y <= WorstPixel::kSide / 2; ++y) {
        for (int x = -WorstPixel::kSide / 2; x <= WorstPixel::kSide / 2; ++x) {
            const glm::ivec2 at = glm::clamp(error.worst + glm::ivec2(x, y), glm::ivec2(0), truth.size - 1);
            const std::uint8_t* pixel = image.pixel(at.x, at.y);
            const glm::dvec3& color = truth.colors[static_cast<std::size_t>(at.y * truth.size.x + at.x)];
            for (int c = 0; c < 3; ++c) {
                result.seen.push_back(pixel[c]);
                result.expected.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0, 1.0))));
            }
        }
    }
    return result;
}

base::Image sheet_of(const std::vector<WorstPixel>& pixels) {
    const int count = static_cast<int>(pixels.size());
    base::Image image{count * (kCell + kGap) + kGap, 2 * (kCell + kGap) + kGap, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 255);
    for (int i = 0; i < count; ++i) {
        const WorstPixel& each = pixels[static_cast<std::size_t>(i)];
        const int x = kGap + i * (kCell + kGap);
        draw(image, {x, kGap}, each.seen);
        draw(image, {x, kCell + 2 * kGap}, each.expected);
    }
    return image;
}

}  // namespace bench
