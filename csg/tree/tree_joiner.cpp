#include "csg/tree/tree_joiner.h"

#include <algorithm>

namespace csg {

namespace {

std::vector<NodeId> present(std::vector<NodeId> nodes) {
    std::erase(nodes, kNoNode);
    return nodes;
}

}  // namespace

std::vector<NodeId> TreeJoiner::add(const Tree& tree) {
    for (Statement statement : tree.statements()) {
        statement.where = moved(tree, statement.where);
        statements_.push_back(std::move(statement));
    }
    std::vector<NodeId> added(tree.size(), kNoNode);  // Children stand before their parents.
    for (NodeId id = 0; id < tree.size(); ++id) {
        if (modified_ == Modified::AsIs || !tree.node(id).modifiers.background) {
            std::vector<NodeId> children;
            for (const NodeId child : tree.children(id)) {
                children.push_back(added[child]);
            }
            added[id] = copy(tree, id, present(std::move(children)));
        }
    }
    return added;
}

NodeId TreeJoiner::like(const Tree& tree, NodeId id, const std::vector<NodeId>& children) {
    const std::vector<NodeId> left = present(children);
    return left.empty() ? kNoNode : copy(tree, id, left);
}

NodeId TreeJoiner::combine(Operation operation, const std::vector<NodeId>& operands) {
    if (operation == Operation::Difference && (operands.empty() || operands.front() == kNoNode)) {
        return kNoNode;
    }
    const std::vector<NodeId> left = present(operands);
    return left.empty() ? kNoNode : builder_.combine(operation, left, {});
}

NodeId TreeJoiner::colored(const Rgba& color, NodeId node) {
    return node == kNoNode ? kNoNode : builder_.color(color, {&node, 1}, {});
}

NodeId TreeJoiner::transformed(const glm::dmat4& matrix, NodeId node) {
    return node == kNoNode ? kNoNode : builder_.transform(matrix, {&node, 1}, {});
}

Tree TreeJoiner::finish(const std::vector<NodeId>& united) {
    std::ranges::sort(statements_, {}, &Statement::where);  // Several trees may have called the same library.
    const auto same = std::unique(statements_.begin(), statements_.end(),
                                  [](const Statement& a, const Statement& b) { return a.where == b.where; });
    statements_.erase(same, statements_.end());
    return builder_.finish(builder_.combine(Operation::Group, present(united), {}), std::move(statements_));
}

SourceLocation TreeJoiner::moved(const Tree& tree, SourceLocation where) {
    if (where.known() && where.file < tree.files().size()) {
        where.file = builder_.file(tree.files()[where.file]);
    }
    return where;
}

NodeId TreeJoiner::copy(const Tree& tree, NodeId id, const std::vector<NodeId>& children) {
    const SourceLocation where = moved(tree, tree.node(id).where);
    const Modifiers modifiers = modified_ == Modified::AsIs ? tree.node(id).modifiers : Modifiers{};
    switch (const Operation operation = tree.node(id).operation) {
        case Operation::Group:
        case Operation::Union:
        case Operation::Difference:
        case Operation::Intersection:
            return builder_.combine(operation, children, where, modifiers);
        case Operation::Transform:
            return builder_.transform(tree.matrix(id), children, where, modifiers);
        case Operation::Color:
            return builder_.color(tree.color(id), children, where, modifiers);
        case Operation::Leaf:
            return builder_.leaf(tree.shape(id), where, modifiers);
        case Operation::Mesh:
            return builder_.mesh(tree.mesh(id), children, where, modifiers);
    }
    return kNoNode;
}

}  // namespace csg
