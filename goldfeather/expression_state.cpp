#include "goldfeather/expression_state.h"

#include <algorithm>

namespace goldfeather {

ExpressionTree::ExpressionTree(const csg::Scene& scene)
    : nodes_(scene.expressions.size()),
      counts_(scene.expressions.size(), 0),
      leaf_nodes_(scene.leaves.size(), kNone),
      part_count_(scene.parts.size()) {
    for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
        const csg::Part& part = scene.parts[id];
        // Parents stand behind their children: going backwards, a node's own complement is known when it is reached.
        for (std::uint32_t i = part.root + 1; i-- > part.first_expression;) {
            const csg::Expression& e = scene.expressions[i];
            nodes_[i].part = id;
            if (e.kind == csg::ExpressionKind::Leaf) {
                leaf_nodes_[e.leaf] = i;
                continue;
            }
            const auto children = scene.children(e);
            const auto count = static_cast<std::int32_t>(children.size());
            const bool difference = e.kind == csg::ExpressionKind::Difference;
            // An intersection or difference of nothing is never true.
            nodes_[i].need = e.kind == csg::ExpressionKind::Union || count == 0 ? 1 : count;
            counts_[i] = difference && count > 0 ? count - 1 : 0;  // What is subtracted speaks for it while false.
            for (std::size_t k = 0; k < children.size(); ++k) {
                const bool subtracted = difference && k > 0;
                Node& child = nodes_[children[k]];
                child.parent = i;
                child.vote = subtracted ? -1 : 1;
                child.complement = nodes_[i].complement != subtracted;
            }
        }
    }
}

void ExpressionState::wait(std::uint32_t node) {
    if (waiting_[node] == 0) {
        waiting_[node] = 1;
        heap_.push_back({node, counts_[node] >= tree_.node(node).need});
        std::push_heap(heap_.begin(), heap_.end());
    }
}

void ExpressionState::toggle(std::span<const csg::LeafId> leaves, std::vector<csg::PartId>& changed) {
    for (const csg::LeafId leaf : leaves) {
        const std::uint32_t node = tree_.node_of(leaf);
        wait(node);
        counts_[node] ^= 1;
    }
    // Parents stand behind their children: when a node's turn comes, all below it have had theirs.
    while (!heap_.empty()) {
        std::pop_heap(heap_.begin(), heap_.end());
        const Turned turned = heap_.back();
        heap_.pop_back();
        waiting_[turned.node] = 0;
        const ExpressionTree::Node& n = tree_.node(turned.node);
        const bool value = counts_[turned.node] >= n.need;
        if (value == turned.before) {
            continue;
        }
        if (n.parent == ExpressionTree::kNone) {
            parts_[n.part] = value ? 1 : 0;
            changed.push_back(n.part);
        } else {
            wait(n.parent);
            counts_[n.parent] += value ? n.vote : -n.vote;
        }
    }
}

}  // namespace goldfeather
