#include "csg/tree/additions.h"

#include <map>
#include <vector>

#include "csg/tree/tree_joiner.h"

namespace csg {

namespace {

/// What the model is the union of: additions stand beside these, so that they stay parts of their own.
std::vector<NodeId> objects_of(const Tree& model, TreeJoiner& joiner) {
    if (model.root() == kNoNode) {
        return {};
    }
    const std::vector<NodeId> ids = joiner.add(model);
    const Node& root = model.node(model.root());
    if (root.operation != Operation::Group || root.modifiers != Modifiers{} || root.where.known()) {
        return {ids[model.root()]};
    }
    std::vector<NodeId> objects;
    for (const NodeId child : model.children(model.root())) {
        objects.push_back(ids[child]);
    }
    return objects;
}

}  // namespace

Tree with_additions(const Tree& model, std::span<const Addition> additions) {
    TreeJoiner joiner(TreeJoiner::Modified::AsIs);
    std::vector<NodeId> all = objects_of(model, joiner);
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
