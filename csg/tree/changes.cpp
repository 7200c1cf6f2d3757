#include "csg/tree/changes.h"

#include <algorithm>
#include <vector>

namespace csg {
namespace {

constexpr Rgba kSame{0.72F, 0.72F, 0.72F, 0.3F}, kAdded{0.25F, 0.68F, 0.3F, 1}, kRemoved{0.86F, 0.24F, 0.2F, 1};

/// Puts trees into one.
class Joiner {
  public:
    /// The root's number; kNoNode where the tree holds nothing.
    NodeId add(const Tree& tree) {
        if (tree.root() == kNoNode) {
            return kNoNode;
        }
        std::vector<std::uint32_t> files;
        for (const std::string& file : tree.files()) {
            files.push_back(builder_.file(file));
        }
        const auto moved = [&](SourceLocation where) {
            where.file = where.known() && where.file < files.size() ? files[where.file] : where.file;
            return where;
        };
        for (Statement statement : tree.statements()) {
            statement.where = moved(statement.where);
            statements_.push_back(std::move(statement));
        }
        std::vector<NodeId> added(tree.size(), kNoNode);  // Children stand before their parents.
        for (NodeId id = 0; id < tree.size(); ++id) {
            added[id] =
                tree.node(id).modifiers.background ? kNoNode : copy(tree, id, added, moved(tree.node(id).where));
        }
        return added[tree.root()];
    }

    /// `second` may be nothing.
    NodeId combine(Operation operation, NodeId first, NodeId second) {
        std::vector<NodeId> operands{first};
        if (second != kNoNode) {
            operands.push_back(second);
        }
        return builder_.combine(operation, operands, {});
    }

    NodeId colored(const Rgba& color, NodeId node) { return builder_.color(color, {&node, 1}, {}); }

    Tree finish(const std::vector<NodeId>& united) {
        std::ranges::sort(statements_, {}, &Statement::where);  // Both may have called the same library.
        const auto same = std::unique(statements_.begin(), statements_.end(),
                                      [](const Statement& a, const Statement& b) { return a.where == b.where; });
        statements_.erase(same, statements_.end());
        return builder_.finish(builder_.combine(Operation::Group, united, {}), std::move(statements_));
    }

  private:
    NodeId copy(const Tree& tree, NodeId id, const std::vector<NodeId>& added, const SourceLocation& where) {
        std::vector<NodeId> children;
        for (const NodeId child : tree.children(id)) {
            if (added[child] != kNoNode) {
                children.push_back(added[child]);
            }
        }
        switch (const Operation operation = tree.node(id).operation) {
            case Operation::Group:
            case Operation::Union:
            case Operation::Difference:
            case Operation::Intersection:
                return builder_.combine(operation, children, where);
            case Operation::Transform:
                return builder_.transform(tree.matrix(id), children, where);
            case Operation::Color:
                return builder_.color(tree.color(id), children, where);
            case Operation::Leaf:
                return builder_.leaf(tree.shape(id), where);
            case Operation::Mesh:
                return builder_.mesh(tree.mesh(id), children, where);
        }
        return kNoNode;
    }

    TreeBuilder builder_;
    std::vector<Statement> statements_;
};

}  // namespace

Tree changes(const Tree& before, const Tree& after) {
    Joiner joiner;
    const NodeId a = joiner.add(before), b = joiner.add(after);
    std::vector<NodeId> parts;
    if (a != kNoNode && b != kNoNode) {
        parts.push_back(joiner.colored(kSame, joiner.combine(Operation::Intersection, a, b)));
    }
    if (b != kNoNode) {
        parts.push_back(joiner.colored(kAdded, joiner.combine(Operation::Difference, b, a)));
    }
    if (a != kNoNode) {
        parts.push_back(joiner.colored(kRemoved, joiner.combine(Operation::Difference, a, b)));
    }
    return joiner.finish(parts);
}

Tree less(const Tree& first, const Tree& second) {
    Joiner joiner;
    const NodeId a = joiner.add(first), b = joiner.add(second);
    return joiner.finish(a == kNoNode ? std::vector<NodeId>{}
                                      : std::vector{joiner.combine(Operation::Difference, a, b)});
}

}  // namespace csg
