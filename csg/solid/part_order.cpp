#include "csg/solid/part_order.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace csg::solid {
namespace {

int place_of(PartKind kind) {
    switch (kind) {
        case PartKind::Highlight:
            return 0;
        case PartKind::Solid:
            return 1;
        case PartKind::Translucent:
            return 2;
        case PartKind::Background:
            return 3;
    }
    return 1;
}

/// Colors that are not given are below all others.
std::array<float, 4> shade_of(const Rgba& c, PartKind kind) {
    const bool seen_through = kind == PartKind::Translucent || kind == PartKind::Background;
    return {seen_through ? (c.a < 0 ? 1 : c.a) : 1, c.r, c.g, c.b};
}

/// Below 0 where `a` comes first, 0 where the two are alike.
template <typename T>
int larger_first(const T& a, const T& b) {
    return a > b ? -1 : b > a ? 1 : 0;
}

int compare_points(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
    if (a.size() != b.size()) {
        return larger_first(a.size(), b.size());
    }
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin());
    if (differ.first == a.end()) {
        return 0;
    }
    const glm::dvec3 &p = *differ.first, &q = *differ.second;
    return larger_first(std::array{p.x, p.y, p.z}, std::array{q.x, q.y, q.z});
}

int compare_leaves(const Scene& scene, const Geometry* geometry, const Part& a, const Part& b) {
    if (a.leaf_count != b.leaf_count) {
        return larger_first(a.leaf_count, b.leaf_count);
    }
    for (std::uint32_t i = 0; i < a.leaf_count; ++i) {
        const LeafId left = a.first_leaf + i, right = b.first_leaf + i;
        int order = larger_first(shade_of(scene.leaves[left].color, PartKind::Solid),
                                 shade_of(scene.leaves[right].color, PartKind::Solid));
        if (order == 0 && geometry != nullptr) {
            order = compare_points(geometry->leaves[left].points, geometry->leaves[right].points);
        }
        if (order != 0) {
            return order;
        }
    }
    return 0;
}

int compare_expressions(const Scene& scene, const Part& a, const Part& b) {
    const std::uint32_t of_a = a.root - a.first_expression, of_b = b.root - b.first_expression;
    if (of_a != of_b) {
        return larger_first(of_a, of_b);
    }
    for (std::uint32_t i = 0; i <= of_a; ++i) {
        const Expression &left = scene.expressions[a.first_expression + i],
                         &right = scene.expressions[b.first_expression + i];
        const int order = larger_first(std::array{static_cast<std::uint32_t>(left.kind), left.child_count},
                                       std::array{static_cast<std::uint32_t>(right.kind), right.child_count});
        if (order != 0) {
            return order;
        }
    }
    return 0;
}

int compare(const Scene& scene, const Geometry* geometry, const Part& a, const Part& b) {
    int order = place_of(a.kind) - place_of(b.kind);
    if (order == 0) {
        order = larger_first(shade_of(a.color, a.kind), shade_of(b.color, b.kind));
    }
    if (order == 0) {
        order = compare_leaves(scene, geometry, a, b);
    }
    return order != 0 ? order : compare_expressions(scene, a, b);
}

}  // namespace

std::vector<PartId> part_order(const Scene& scene, const Geometry* geometry) {
    std::vector<PartId> order(scene.parts.size());
    std::iota(order.begin(), order.end(), PartId{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](PartId a, PartId b) { return compare(scene, geometry, scene.parts[a], scene.parts[b]) < 0; });
    return order;
}

std::vector<std::uint32_t> ranks_of(const std::vector<PartId>& order) {
    std::vector<std::uint32_t> ranks(order.size());
    for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
        ranks[order[rank]] = rank;
    }
    return ranks;
}

}  // namespace csg::solid
