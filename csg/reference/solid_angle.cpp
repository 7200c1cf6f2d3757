#include "csg/reference/solid_angle.h"

#include <cmath>
#include <numbers>

namespace csg::reference {

long winding_number(const Mesh& mesh, const glm::dvec3& point) {
    double half_angle = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = mesh.points[t.x] - point, b = mesh.points[t.y] - point, c = mesh.points[t.z] - point;
        const double p = glm::length(a), q = glm::length(b), r = glm::length(c);
        half_angle += std::atan2(glm::dot(a, glm::cross(b, c)),
                                 p * q * r + glm::dot(a, b) * r + glm::dot(b, c) * p + glm::dot(c, a) * q);
    }
    return std::lround(half_angle / (2 * std::numbers::pi));
}

}  // namespace csg::reference
