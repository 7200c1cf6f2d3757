#include "tests/csg/reference/membership.h"

#include <cmath>
#include <numbers>
#include <random>

#include "csg/reference/expression_value.h"

namespace meshes {

int winding_number(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles, const glm::dvec3& point) {
    double angle = 0;  // half of it (van Oosterom and Strackee 1983)
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a = points[t.x] - point, b = points[t.y] - point, c = points[t.z] - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        angle += std::atan2(glm::dot(a, glm::cross(b, c)),
                            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

std::size_t count_wrong_points(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                               const csg::reference::Mesh& mesh, const csg::Box& box, std::size_t count) {
    std::mt19937 random(1);
    std::vector<char> values;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
        glm::dvec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = box.lo[axis] + box.size()[axis] * (static_cast<double>(random()) / 4294967296.0);
        }
        const auto in_leaf = [&](csg::LeafId id) {
            const csg::solid::PlacedLeaf& leaf = geometry.leaves[id];
            return winding_number(leaf.points, leaf.triangles, p) != 0;
        };
        bool inside = false;
        for (const csg::PartId part : csg::reference::solid_parts(scene)) {
            inside |= csg::evaluate(scene, scene.parts[part], in_leaf, values);
        }
        wrong += winding_number(mesh.points, mesh.triangles, p) != (inside ? 1 : 0) ? 1 : 0;
    }
    return wrong;
}

}  // namespace meshes
