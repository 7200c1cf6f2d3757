#include "csg/solid/wall_bends.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace csg::solid {
namespace {

/// Of a slice's walls, two for each edge; a zero where a triangle has no area.
using WallNormals = std::vector<glm::dvec3>;

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    if (glm::dot(a, a) == 0 || glm::dot(b, b) == 0) {
        return 0;
    }
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * (180 / std::numbers::pi);
}

WallNormals normals_of(const Solid& solid, std::size_t first, std::size_t count) {
    WallNormals normals;
    normals.reserve(count);
    for (std::size_t i = first; i < first + count; ++i) {
        const glm::uvec3& t = solid.triangles[i];
        const glm::dvec3& a = solid.points[t.x];
        const glm::dvec3 across = glm::cross(solid.points[t.y] - a, solid.points[t.z] - a);
        const double length = glm::length(across);
        normals.push_back(length > 0 ? across / length : glm::dvec3(0.0));
    }
    return normals;
}

}  // namespace

void group_walls(Solid& solid, std::size_t first, const OutlineCurves& curves, std::size_t slices) {
    std::vector<FacetGroup> walls;      // Of a slice.
    std::vector<std::size_t> previous;  // By edge: that before it in its loop.
    for (const std::vector<FacetGroup>& loop : curves.edges) {
        const std::size_t begin = previous.size();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            previous.push_back(begin + (i + loop.size() - 1) % loop.size());
            walls.insert(walls.end(), 2, loop[i]);
        }
    }
    solid.groups.resize(first);
    for (std::size_t slice = 0; slice < slices; ++slice) {
        solid.groups.insert(solid.groups.end(), walls.begin(), walls.end());
    }
    if (slices == 1) {
        return;  // Bends are those of the outline, or less.
    }
    const auto bend = [&](std::size_t a, std::size_t b, const glm::dvec3& m, const glm::dvec3& n) {
        const double angle = degrees_between(m, n);
        solid.groups[a].bends(angle);
        solid.groups[b].bends(angle);
    };
    WallNormals below;
    for (std::size_t slice = 0; slice < slices; ++slice) {
        const std::size_t begin = first + slice * walls.size();
        WallNormals here = normals_of(solid, begin, walls.size());
        for (std::size_t edge = 0; edge < previous.size(); ++edge) {
            const std::size_t at = 2 * edge, before = 2 * previous[edge];
            bend(begin + at, begin + at + 1, here[at], here[at + 1]);
            for (std::size_t i = 0; i < 2; ++i) {
                if (smooth_between(walls[at], walls[before])) {
                    bend(begin + at + i, begin + before + i, here[at + i], here[before + i]);
                }
                if (!below.empty()) {
                    bend(begin + at + i, begin + at + i - walls.size(), here[at + i], below[at + i]);
                }
            }
        }
        below = std::move(here);
    }
}

}  // namespace csg::solid
