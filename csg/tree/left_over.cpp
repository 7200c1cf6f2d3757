#include "csg/tree/left_over.h"

#include <algorithm>
#include <vector>

#include "csg/tree/tree_joiner.h"

namespace csg {

Tree left_over(const Tree& tree, std::span<const SourceLocation> hidden, const std::optional<SourceLocation>& only) {
    TreeJoiner joiner;
    (void)joiner.add(tree);
    std::vector<NodeId> left(tree.size(), kNoNode);   // What is left of a node, …
    std::vector<NodeId> found(tree.size(), kNoNode);  // … and of that what `only` names.
    for (NodeId id = 0; id < tree.size(); ++id) {
        const Node& node = tree.node(id);
        if (node.modifiers.background || std::find(hidden.begin(), hidden.end(), node.where) != hidden.end()) {
            continue;
        }
        std::vector<NodeId> operands, named;
        for (const NodeId child : tree.children(id)) {
            operands.push_back(left[child]);
            named.push_back(found[child]);
        }
        const bool subtracts = node.operation == Operation::Difference;
        left[id] = node.operation == Operation::Leaf                                ? joiner.like_leaf(tree, id)
                   : subtracts && (operands.empty() || operands.front() == kNoNode) ? kNoNode
                                                                                    : joiner.like(tree, id, operands);
        if (only && node.where == *only) {
            found[id] = left[id];
        } else if (std::any_of(named.begin(), named.end(), [](NodeId each) { return each != kNoNode; })) {
            const bool combines = subtracts || node.operation == Operation::Intersection;
            found[id] = combines ? joiner.combine(Operation::Union, named) : joiner.like(tree, id, named);
        }
    }
    const NodeId root = tree.root();
    return joiner.finish({root == kNoNode ? kNoNode : only ? found[root] : left[root]});
}

}  // namespace csg
