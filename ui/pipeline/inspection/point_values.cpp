#include "ui/pipeline/inspection/point_values.h"

#include <algorithm>
#include <functional>

namespace ui {

ExpressionLinks::ExpressionLinks(const csg::Scene& s)
    : scene(s),
      parent(s.expressions.size(), kNone),
      first(s.expressions.size(), 0),
      of_leaf(s.leaves.size(), kNone),
      part(s.expressions.size(), 0) {
    for (csg::PartId id = 0; id < s.parts.size(); ++id) {
        for (std::uint32_t i = s.parts[id].first_expression; i <= s.parts[id].root; ++i) {
            const csg::Expression& e = s.expressions[i];
            part[i] = id;
            if (e.kind == csg::ExpressionKind::Leaf) {
                of_leaf[e.leaf] = i;
            }
            const auto children = s.children(e);
            for (std::size_t k = 0; k < children.size(); ++k) {
                parent[children[k]] = i;
                first[children[k]] = k == 0 ? 1 : 0;
            }
        }
    }
}

PointValues::PointValues(const ExpressionLinks& links) : links_(links), at_(links.scene.expressions.size()) {}

void PointValues::go(std::span<const csg::LeafId> inside) {
    for (const std::uint32_t i : touched_) {
        at_[i] = {};
    }
    touched_.clear();
    parts_.clear();
    for (const csg::LeafId leaf : inside) {
        if (links_.of_leaf[leaf] != ExpressionLinks::kNone) {
            heap_.push_back(links_.of_leaf[leaf]);
        }
    }
    const auto later = std::greater<>();
    std::make_heap(heap_.begin(), heap_.end(), later);
    while (!heap_.empty()) {
        // Children stand before their parents: all of them have had their turn.
        std::pop_heap(heap_.begin(), heap_.end(), later);
        const std::uint32_t i = heap_.back();
        heap_.pop_back();
        touched_.push_back(i);
        const csg::Expression& e = links_.scene.expressions[i];
        Node& node = at_[i];
        switch (e.kind) {
            case csg::ExpressionKind::Leaf:
            case csg::ExpressionKind::Union:
                node.value = true;
                break;
            case csg::ExpressionKind::Intersection:
                node.value = node.true_children == e.child_count;
                break;
            case csg::ExpressionKind::Difference:
                node.value = node.first && node.true_children == 1;
                break;
        }
        if (!node.value) {
            continue;
        }
        const std::uint32_t parent = links_.parent[i];
        if (parent == ExpressionLinks::kNone) {
            parts_.push_back(links_.part[i]);
            continue;
        }
        Node& above = at_[parent];
        if (above.true_children++ == 0) {
            heap_.push_back(parent);
            std::push_heap(heap_.begin(), heap_.end(), later);
        }
        above.sum += i;
        above.first = above.first || links_.first[i] != 0;
    }
    std::sort(parts_.begin(), parts_.end());
}

}  // namespace ui
