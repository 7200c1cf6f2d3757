#include "npr/painter/pixel_frame.h"

#include <algorithm>

namespace npr {

void PixelFrame::note(int layer, bool hit, glm::vec4 color) {
    if (!lines_.empty()) {
        const float depth = line_depth(layer);
        for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
            page->add({*line, depth, 0});
        }
        lines_.clear();
    }
    if (hit && color.a > 0) {
        const glm::uvec2 ids = surface_ids(noted, layer);
        page->add({color, layer_depth(noted, layer), part_looks[leaf_rows[leaf_of(ids)].part.x].rank + 1});
    }
}

float PixelFrame::line_depth(int layer) const {
    const glm::ivec2 lo = glm::max(noted - reach, 0), hi = glm::min(noted + reach, size - 1);
    float nearest = 0;
    for (int y = lo.y; y <= hi.y; ++y) {
        for (int x = lo.x; x <= hi.x; ++x) {
            nearest = std::max(nearest, layer_depth({x, y}, layer));
        }
    }
    if (nearest <= 0) {
        return nearest;
    }
    // As far as a surface at 75 degrees to the picture rises within the lines' reach.
    const float pixel = 2 * view.picture.z / view.picture.y, rise = 4 * static_cast<float>(reach) * pixel;
    if (view.depth_range.z > 0.5F) {
        return nearest + rise / (view.depth_range.y - view.depth_range.x);
    }
    return nearest / std::max(1 - rise, 0.5F);
}

}  // namespace npr
