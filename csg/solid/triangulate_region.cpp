#include "csg/solid/triangulate_region.h"

#include "csg/solid/ear_cutting.h"
#include "csg/solid/sweep_triangulation.h"
#include "csg/solid/triangulate.h"

namespace csg::solid {
namespace {

bool is_convex(const IndexedOutline& outline) {
    if (outline.loops.size() != 1) {
        return false;
    }
    const auto& loop = outline.loops[0];
    int changes = 0;
    double last = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 &a = outline.points[loop[i]], &b = outline.points[loop[(i + 1) % loop.size()]],
                         &c = outline.points[loop[(i + 2) % loop.size()]];
        if (turn(a, b, c) <= 0) {
            return false;
        }
        const double direction = b.x != a.x ? b.x - a.x : b.y - a.y;
        changes += direction * last < 0;
        last = direction;
    }
    return changes <= 2;
}

}  // namespace

std::vector<glm::uvec3> triangulate_region(const IndexedOutline& outline) {
    std::vector<glm::uvec3> triangles;
    if (is_convex(outline)) {
        triangulate_convex(outline.loops[0], triangles);
        return triangles;
    }
    if (auto swept = triangulate_by_sweep(exact_points(outline.points), outline.loops)) {
        return std::move(*swept);
    }
    // No region: loop by loop, so that it is closed all the same.
    for (const auto& loop : outline.loops) {
        Ring ring;
        for (const std::uint32_t index : loop) {
            ring.push_back({outline.points[index], index});
        }
        if (ring.size() > 2) {
            cut_ears(ring, triangles);
        }
    }
    return triangles;
}

}  // namespace csg::solid
