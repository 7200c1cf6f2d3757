#include "csg/tree/additions.h"

#include <map>
#include <vector>

#include "csg/tree/tree_joiner.h"

namespace csg {

Tree with_additions(const Tree& model, std::span<const Addition> additions) {
    TreeJoiner joiner(TreeJoiner::Modified::AsIs);
    std::vector<NodeId> all{joiner.add_root(model)};
    std::map<const Tree*, std::vector<NodeId>> others;
    for (const Addition& addition : additions) {
        if (addition.tree != nullptr && !others.contains(addition.tree)) {
            others[addition.tree] = joiner.add(*addition.tree);
        }
        const NodeId node =
            addition.tree != nullptr ? others[addition.tree][addition.node] : joiner.leaf(addition.shape);
        all.push_back(joiner.colored(addition.color, joiner.transformed(addition.to_world, node)));
    }
    return joiner.finish(all);
}

}  // namespace csg
