// Puts trees into one, with more operations on their nodes. Internal to csg/tree.
#pragma once

#include <vector>

#include "csg/tree/tree.h"

namespace csg {

/// Nodes keep their places, and calls theirs.
class TreeJoiner {
  public:
    enum class Modified {
        Solid,  ///< `%` subtrees are no part of the solid, and are left out; `#` and `!` are taken off.
        AsIs,   ///< Modifiers stay.
    };
    explicit TreeJoiner(Modified modified = Modified::Solid) : modified_(modified) {}

    /// What the nodes of the tree have become, by their ids; kNoNode of what is left out.
    std::vector<NodeId> add(const Tree& tree);
    /// That of the root; kNoNode where there is nothing.
    NodeId add_root(const Tree& tree) { return tree.root() == kNoNode ? kNoNode : add(tree)[tree.root()]; }

    /// A node like that of `tree`, with other children; kNoNode where there are none.
    NodeId like(const Tree& tree, NodeId id, const std::vector<NodeId>& children);
    NodeId like_leaf(const Tree& tree, NodeId id) { return copy(tree, id, {}); }
    /// Operands that are kNoNode are left out; kNoNode where none is left, or the first of a difference is none.
    NodeId combine(Operation operation, const std::vector<NodeId>& operands);
    NodeId colored(const Rgba& color, NodeId node);
    NodeId transformed(const glm::dmat4& matrix, NodeId node);
    NodeId leaf(LeafShape shape) { return builder_.leaf(std::move(shape), {}); }

    /// All that is not kNoNode.
    Tree finish(const std::vector<NodeId>& united);

  private:
    [[nodiscard]] SourceLocation moved(const Tree& tree, SourceLocation where);
    NodeId copy(const Tree& tree, NodeId id, const std::vector<NodeId>& children);

    Modified modified_;
    TreeBuilder builder_;
    std::vector<Statement> statements_;
};

}  // namespace csg
