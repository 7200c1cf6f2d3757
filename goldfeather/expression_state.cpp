#include "goldfeather/expression_state.h"

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

}  // namespace goldfeather
