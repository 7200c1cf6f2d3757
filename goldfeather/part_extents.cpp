#include "goldfeather/part_extents.h"

#include <algorithm>
#include <cmath>

namespace goldfeather {

PartExtent extent_of(const csg::Part& part, const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    if (part.leaf_count == 0 || part.root < part.first_expression) {
        return {};
    }
    const std::uint32_t first = part.first_expression, count = part.root - first + 1;
    std::vector<csg::Box> leaf_boxes(scene.leaves.size());
    for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
        leaf_boxes[leaf] = geometry.leaves[leaf].box;
    }
    const csg::Box box = csg::bounds(scene, part, leaf_boxes);
    if (box.empty()) {
        return {};
    }
    const glm::dvec3 center = box.center();
    double squared = 0;
    std::vector<char> added(count, 0);
    added.back() = 1;
    for (std::uint32_t i = count; i-- > 0;) {
        const csg::Expression& e = scene.expressions[first + i];
        if (added[i] == 0) {
            continue;
        }
        if (e.kind == csg::ExpressionKind::Leaf) {
            for (const glm::dvec3& point : geometry.leaves[e.leaf].points) {
                const glm::dvec3 away = glm::clamp(point, box.lo, box.hi) - center;
                squared = std::max(squared, glm::dot(away, away));
            }
            continue;
        }
        const auto children = scene.children(e);
        const std::size_t kept =
            e.kind == csg::ExpressionKind::Difference ? std::min<std::size_t>(1, children.size()) : children.size();
        for (std::size_t c = 0; c < kept; ++c) {
            added[children[c] - first] = 1;
        }
    }
    return {center, std::sqrt(squared)};
}

}  // namespace goldfeather
