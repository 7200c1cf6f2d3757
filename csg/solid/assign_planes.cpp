#include "csg/solid/assign_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/stop.h"

namespace csg::solid {
namespace {

/// Of what is known better than by corners.
constexpr int kExact = 1023, kUnknown = -2000;

}  // namespace

Plane plane_of(const PlacedLeaf& leaf, std::uint32_t triangle) {
    const glm::uvec3& t = leaf.triangles[triangle];
    return triangle < leaf.face_triangles ? leaf.face
                                          : plane_through(leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]);
}

int accuracy(const PlacedLeaf& leaf, std::uint32_t triangle) {
    if (triangle < leaf.face_triangles) {
        return kExact;
    }
    const glm::uvec3& t = leaf.triangles[triangle];
    const glm::dvec3 &a = leaf.points[t.x], &b = leaf.points[t.y], &c = leaf.points[t.z];
    const double longest =
        std::sqrt(std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)}));
    const double height = glm::length(glm::cross(b - a, c - a)) / longest;
    return height > 0 && std::isfinite(height) ? std::ilogb(height) : kUnknown;
}

void assign_planes(Geometry& geometry, const std::stop_token& stop) {
    struct Item {
        int accuracy;
        std::uint32_t leaf, triangle;
    };
    std::size_t count = 0;
    for (const PlacedLeaf& leaf : geometry.leaves) {
        count += leaf.triangles.size();
    }
    std::vector<Item> items;
    items.reserve(count);
    // Of the next item of this accuracy, from the best down; first, how many there are.
    std::vector<std::uint32_t> place(kExact - kUnknown + 1, 0);
    const auto place_of = [&](int accuracy) -> std::uint32_t& {
        return place[static_cast<std::size_t>(kExact - accuracy)];
    };
    for (std::uint32_t l = 0; l < geometry.leaves.size(); ++l) {
        base::end_if_asked(stop);
        PlacedLeaf& leaf = geometry.leaves[l];
        leaf.planes.resize(leaf.triangles.size());
        for (std::uint32_t t = 0; t < leaf.triangles.size(); ++t) {
            items.push_back({accuracy(leaf, t), l, t});
            ++place_of(items.back().accuracy);
        }
    }
    std::uint32_t next = 0;
    for (std::uint32_t& at : place) {
        at = std::exchange(next, next + at);
    }
    base::PacedStop paced(stop);
    std::vector<std::uint32_t> order(items.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        paced();
        order[place_of(items[i].accuracy)++] = i;
    }
    for (const std::uint32_t i : order) {
        paced();
        const Item& item = items[i];
        PlacedLeaf& leaf = geometry.leaves[item.leaf];
        const glm::uvec3& t = leaf.triangles[item.triangle];
        leaf.planes[item.triangle] =
            geometry.planes.add(plane_of(leaf, item.triangle), leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]);
    }
}

}  // namespace csg::solid
