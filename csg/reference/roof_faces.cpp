#include "csg/reference/roof_faces.h"

#include "csg/solid/outline.h"

namespace csg::reference {

std::vector<std::uint32_t> reduced(std::span<const std::uint32_t> loop) {
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t id : loop) {
        if (!kept.empty() && kept.back() == id) {
            continue;
        }
        if (kept.size() > 1 && kept[kept.size() - 2] == id) {
            kept.pop_back();
        } else {
            kept.push_back(id);
        }
    }
    std::size_t from = 0, to = kept.size();
    while (to - from > 1) {
        const bool same_ends = kept[from] == kept[to - 1], longer = to - from > 2;
        if (!same_ends && longer && kept[from + 1] == kept[to - 1]) {
            ++from;
        } else if (same_ends || (longer && kept[from] == kept[to - 2])) {
            --to;
        } else {
            break;
        }
    }
    return {kept.begin() + static_cast<std::ptrdiff_t>(from), kept.begin() + static_cast<std::ptrdiff_t>(to)};
}

void triangulate_over_eaves(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                            std::vector<glm::uvec3>& triangles) {
    // No corner lies below another, seen from the eaves, so every corner that turns left can be cut off.
    const auto at = [&](std::uint32_t id) { return glm::dvec2(points[id]); };
    std::vector<std::uint32_t> open;
    for (const std::uint32_t id : face) {
        while (open.size() > 1 && solid::turn(at(open[open.size() - 2]), at(open.back()), at(id)) > 0) {
            triangles.emplace_back(open[open.size() - 2], open.back(), id);
            open.pop_back();
        }
        open.push_back(id);
    }
    for (std::size_t i = 2; i < open.size(); ++i) {  // What rounding left.
        triangles.emplace_back(open[0], open[i - 1], open[i]);
    }
}

}  // namespace csg::reference
