#include "csg/reference/box_pairs.h"

#include <algorithm>
#include <numeric>

namespace csg::reference {

BoxTree::BoxTree(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    while (first_leaf_ * kMostInLeaf < boxes.size())
        first_leaf_ *= 2;
    bounds_.resize(2 * first_leaf_);
    build({1, 0, order_.size()});
}

void BoxTree::build(const Node& node) {
    Box& box = bounds_[node.number];
    for (std::size_t i = node.from; i < node.to; ++i)
        box = enclose(box, boxes_[order_[i]]);
    if (is_leaf(node))
        return;
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.from), at(node.right().from), at(node.to), [&](std::uint32_t a, std::uint32_t b) {
        return boxes_[a].lo[axis] + boxes_[a].hi[axis] < boxes_[b].lo[axis] + boxes_[b].hi[axis];
    });
    build(node.left());
    build(node.right());
}

}  // namespace csg::reference
