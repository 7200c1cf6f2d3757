#include "csg/solid/winding_number.h"

#include <cmath>
#include <numbers>

namespace csg::solid {

long winding_number(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
                    const glm::dvec3& point) {
    double half_angles = 0;
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a = points[t.x] - point, b = points[t.y] - point, c = points[t.z] - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        half_angles += std::atan2(glm::dot(a, glm::cross(b, c)),
                                  la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::lround(half_angles / (2 * std::numbers::pi));
}

}  // namespace csg::solid
