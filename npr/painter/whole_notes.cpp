#include "npr/painter/whole_notes.h"

#include <algorithm>
#include <cmath>

namespace npr {
namespace {

constexpr int kFarthest = 24;  ///< Pixels that strokes are looked after.

float srgb(float linear) {
    return linear > 0.0031308F ? 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F : 12.92F * linear;
}

}  // namespace

glm::vec4 straight_srgb(const glm::vec4& light) {
    const float alpha = std::max(light.a, 1e-6F);
    return {srgb(light.r / alpha), srgb(light.g / alpha), srgb(light.b / alpha), light.a};
}

Note WholeNotes::note(glm::ivec2 pixel, const glm::vec4& color) const {
    layers::Surface nearest = layers_.at(0, pixel.x, pixel.y);
    for (int far = 1; far <= kFarthest && nearest.depth == 0; far *= 2) {
        const glm::ivec2 lo = glm::max(pixel - far, 0), hi = glm::min(pixel + far, layers_.size - 1);
        for (int y = lo.y; y <= hi.y; ++y) {
            for (int x = lo.x; x <= hi.x; ++x) {
                const layers::Surface s = layers_.at(0, x, y);
                nearest = s.depth > nearest.depth ? s : nearest;
            }
        }
    }
    const layers::SurfaceTable& table = *layers_.table;
    const std::uint32_t rank = nearest.depth > 0 ? table.parts[table.leaves[nearest.leaf].part.x].rank + 1 : 0;
    return {straight_srgb(color), nearest.depth, rank};
}

}  // namespace npr
