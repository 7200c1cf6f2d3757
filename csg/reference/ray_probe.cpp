#include "csg/reference/ray_probe.h"

#include <algorithm>
#include <cmath>

namespace csg::reference {
namespace {

std::vector<Box> widened(std::vector<Box> boxes, double by) {
    for (Box& box : boxes) {
        box.lo -= by;
        box.hi += by;
    }
    return boxes;
}

std::vector<Box> boxes_of(const LeafGroup& group) {
    std::vector<Box> boxes;
    boxes.reserve(group.leaves.size());
    for (const solid::PlacedLeaf* leaf : group.leaves) {
        boxes.push_back(leaf->box);
    }
    return boxes;
}

/// 1: from behind the triangle, -1: from in front of it, 0: not at all. Nothing where it cannot be told: beside an
/// edge, or where the origin is as near to the triangle as points may be off, so on either side of it.
std::optional<int> crosses(const solid::PlacedLeaf& leaf, const glm::uvec3& t, const glm::dvec3& o, const glm::dvec3& d,
                           double tolerance) {
    const glm::dvec3 a = leaf.points[t.x] - o, b = leaf.points[t.y] - o, c = leaf.points[t.z] - o;
    const glm::dvec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
    const double u = glm::dot(d, bc), v = glm::dot(d, ca), w = glm::dot(d, ab);
    // Relative to the sizes that cancel in each of them.
    const double scale = 1e-11 * std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
    if ((u > scale && v < -scale) || (v > scale && w < -scale) || (w > scale && u < -scale) ||
        (u < -scale && v > scale) || (v < -scale && w > scale) || (w < -scale && u > scale)) {
        return 0;
    }
    const double volume = glm::dot(a, bc);
    if (std::abs(u) <= scale || std::abs(v) <= scale || std::abs(w) <= scale) {
        // Beside an edge; behind the origin it does not matter.
        if (volume * (u + v + w) < 0 && std::abs(volume) > scale * 1e-3) {
            return 0;
        }
        return {};
    }
    if (std::abs(volume) <= tolerance * glm::length(bc + ca + ab)) {
        return {};
    }
    const bool outwards = u + v + w > 0;
    if ((volume > 0) != outwards) {
        return 0;
    }
    return outwards ? 1 : -1;
}

}  // namespace

struct RayProbe::Triangles {
    explicit Triangles(std::vector<Box> of) : boxes(std::move(of)), tree(boxes) {}
    std::vector<Box> boxes;
    BoxTree tree;
};

RayProbe::RayProbe(const LeafGroup& group, double tolerance)
    : group_(group),
      tolerance_(tolerance),
      boxes_(widened(boxes_of(group), tolerance)),
      tree_(boxes_),
      triangles_(group.leaves.size()) {}

RayProbe::~RayProbe() = default;

const RayProbe::Triangles& RayProbe::triangles(LeafId leaf) const {
    if (!triangles_[leaf]) {
        triangles_[leaf] = std::make_unique<const Triangles>(
            widened(triangle_boxes(group_.leaves[leaf]->points, group_.leaves[leaf]->triangles), tolerance_));
    }
    return *triangles_[leaf];
}

std::optional<Covers> RayProbe::windings(const glm::dvec3& origin, const glm::dvec3& direction,
                                         std::uint32_t without) const {
    Covers result;
    const bool told = tree_.along(origin, direction, [&](std::uint32_t index) {
        const solid::PlacedLeaf& leaf = *group_.leaves[index];
        std::int32_t count = 0;
        const auto pass = [&](std::uint32_t t) {
            if (leaf.planes[t].index == without) {
                return true;
            }
            const std::optional<int> hit = crosses(leaf, leaf.triangles[t], origin, direction, tolerance_);
            count += hit.value_or(0);
            return hit.has_value();
        };
        if (!triangles(index).tree.along(origin, direction, pass)) {
            return false;
        }
        if (count != 0) {
            result.push_back({index, count});
        }
        return true;
    });
    if (!told) {
        return {};
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.leaf < b.leaf; });
    return result;
}

}  // namespace csg::reference
