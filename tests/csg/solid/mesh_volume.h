// The volume of a closed mesh.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace test {

/// Signed: negative for a mesh turned inside out.
[[nodiscard]] inline double mesh_volume(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles) {
    double six = 0;
    for (const glm::uvec3& t : triangles) {
        six += glm::dot(points[t.x], glm::cross(points[t.y], points[t.z]));
    }
    return six / 6;
}

}  // namespace test
