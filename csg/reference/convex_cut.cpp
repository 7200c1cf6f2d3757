#include "csg/reference/convex_cut.h"

namespace csg::reference {

bool cuts(std::vector<glm::dvec3> polygon, std::span<const solid::Plane> planes, double depth) {
    std::vector<glm::dvec3> kept;
    for (const solid::Plane& plane : planes) {
        kept.clear();
        const auto above = [&](const glm::dvec3& p) { return glm::dot(plane.normal, p) - plane.offset + depth; };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            const double from = above(p), to = above(q);
            if (from < 0) {
                kept.push_back(p);
            }
            if ((from < 0) != (to < 0)) {
                kept.push_back(p + (q - p) * (from / (from - to)));
            }
        }
        polygon.swap(kept);
        if (polygon.empty()) {
            return false;
        }
    }
    return true;
}

}  // namespace csg::reference
