#include "csg/reference/box_pairs.h"

#include <algorithm>
#include <numeric>

#include "base/stop.h"

namespace csg::reference {

BoxTree::BoxTree(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    while (first_leaf_ * kMostInLeaf < boxes.size()) {
        first_leaf_ *= 2;
    }
    bounds_.resize(2 * first_leaf_);
    build({1, 0, order_.size()});
}

void BoxTree::build(const Node& node) {
    Box& box = bounds_[node.number];
    for (std::size_t i = node.from; i < node.to; ++i) {
        box = enclose(box, boxes_[order_[i]]);
    }
    if (is_leaf(node)) {
        return;
    }
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.from), at(node.right().from), at(node.to), [&](std::uint32_t a, std::uint32_t b) {
        return boxes_[a].lo[axis] + boxes_[a].hi[axis] < boxes_[b].lo[axis] + boxes_[b].hi[axis];
    });
    build(node.left());
    build(node.right());
}

DisjointSets meeting_sets(const BoxTree& tree, const std::stop_token& stop) {
    DisjointSets sets(tree.size());
    base::PacedStop paced(stop);
    tree.pairs([&](std::uint32_t a, std::uint32_t b) {
        paced();
        sets.unite(std::max(a, b), std::min(a, b));
    });
    return sets;
}

std::vector<Box> triangle_boxes(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles) {
    std::vector<Box> boxes(triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            boxes[t] = enclose(boxes[t], points[triangles[t][k]]);
        }
    }
    return boxes;
}

}  // namespace csg::reference
