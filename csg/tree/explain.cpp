#include "csg/tree/explain.h"

#include <algorithm>
#include <variant>

#include "csg/tree/tree_joiner.h"

namespace csg {

namespace {

constexpr Rgba kTaken{0.86F, 0.2F, 0.16F, 0.55F}, kCutter{0.5F, 0.5F, 0.5F, 0.1F}, kKept{0.25F, 0.68F, 0.3F, 1},
    kLost{0.86F, 0.24F, 0.2F, 0.15F};

bool is_explained(Operation operation) {
    return operation == Operation::Difference || operation == Operation::Intersection;
}

/// Do pieces of its children become pieces of what it makes?
bool keeps_pieces(const Tree& tree, NodeId id) {
    if (tree.node(id).operation != Operation::Mesh) {
        return true;
    }
    const MeshOperation& mesh = tree.mesh(id);
    return std::holds_alternative<LinearExtrude>(mesh) || std::holds_alternative<RotateExtrude>(mesh) ||
           std::holds_alternative<Render>(mesh);
}

/// Pieces of a model that lie where they lay in it.
class Ghost {
  public:
    explicit Ghost(const Tree& tree) : pieces_(tree.size(), kNoNode) {}

    /// What is to be seen of `id`: `own`, and what is of its children.
    void add(TreeJoiner& joiner, const Tree& tree, NodeId id, NodeId own) {
        std::vector<NodeId> below;
        for (const NodeId child : tree.children(id)) {
            below.push_back(pieces_[child]);
        }
        const Operation operation = tree.node(id).operation;
        const bool moves = operation == Operation::Transform || operation == Operation::Mesh;
        const NodeId moved = !keeps_pieces(tree, id) ? kNoNode
                             : moves                 ? joiner.like(tree, id, below)
                                                     : joiner.combine(Operation::Union, below);
        pieces_[id] = own == kNoNode ? moved : joiner.combine(Operation::Union, {own, moved});
    }
    [[nodiscard]] NodeId of(NodeId id) const { return pieces_[id]; }

  private:
    std::vector<NodeId> pieces_;
};

}  // namespace

std::vector<const Statement*> explainable(const Tree& tree) {
    std::vector<const Statement*> found;
    for (NodeId id = 0; id < tree.size(); ++id) {
        const Statement* const statement = is_explained(tree.node(id).operation) ? tree.statement(id) : nullptr;
        if (statement != nullptr) {
            found.push_back(statement);
        }
    }
    const auto place = [](const Statement* a) { return a->where; };
    std::ranges::sort(found, {}, place);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

Tree explained(const Tree& tree, const SourceLocation& where) {
    TreeJoiner joiner;
    const std::vector<NodeId> same = joiner.add(tree);
    Ghost removed(tree), cutters(tree), kept(tree), lost(tree);
    std::vector<NodeId> plain(tree.size(), kNoNode);  // The same without colors and without what an intersection kept.
    bool intersections = false;
    for (NodeId id = 0; id < tree.size(); ++id) {
        const Node& node = tree.node(id);
        if (node.modifiers.background) {
            continue;
        }
        NodeId gone = kNoNode, others = kNoNode, in_all = kNoNode, rest = kNoNode;
        std::vector<NodeId> operands, without;
        for (const NodeId child : tree.children(id)) {
            operands.push_back(same[child]);
            without.push_back(plain[child]);
        }
        plain[id] = node.operation == Operation::Color  ? joiner.combine(Operation::Group, without)
                    : node.operation == Operation::Leaf ? same[id]
                                                        : joiner.like(tree, id, without);
        if (node.where == where && is_explained(node.operation) && operands.size() > 1 && operands[0] != kNoNode) {
            if (node.operation == Operation::Difference) {
                const NodeId cut = joiner.combine(Operation::Union, {operands.begin() + 1, operands.end()});
                gone = cut == kNoNode ? kNoNode : joiner.combine(Operation::Intersection, {operands[0], cut});
                others = joiner.combine(Operation::Difference, {cut, operands[0]});
            } else {
                intersections = true;
                in_all = same[id];
                rest = joiner.combine(Operation::Difference, {joiner.combine(Operation::Union, operands), in_all});
            }
        }
        removed.add(joiner, tree, id, gone);
        cutters.add(joiner, tree, id, others);
        kept.add(joiner, tree, id, in_all);
        lost.add(joiner, tree, id, rest);
    }
    const NodeId root = tree.root();
    if (root == kNoNode) {
        return joiner.finish({});
    }
    const NodeId model = !intersections ? same[root]
                         : kept.of(root) == kNoNode
                             ? plain[root]
                             : joiner.combine(Operation::Difference, {plain[root], kept.of(root)});
    const NodeId still = kept.of(root) == kNoNode || plain[root] == kNoNode
                             ? kNoNode
                             : joiner.combine(Operation::Intersection, {plain[root], kept.of(root)});
    return joiner.finish({model, joiner.colored(kKept, still), joiner.colored(kTaken, removed.of(root)),
                          joiner.colored(kLost, lost.of(root)), joiner.colored(kCutter, cutters.of(root))});
}

Tree without(const Tree& tree, const SourceLocation& where) {
    TreeJoiner joiner;
    (void)joiner.add(tree);
    std::vector<NodeId> left(tree.size(), kNoNode);
    for (NodeId id = 0; id < tree.size(); ++id) {
        const Node& node = tree.node(id);
        if (node.modifiers.background) {
            continue;
        }
        std::vector<NodeId> operands;
        for (const NodeId child : tree.children(id)) {
            operands.push_back(left[child]);
        }
        if (node.where != where) {
            const bool emptied = (is_explained(node.operation) && (operands.empty() || operands[0] == kNoNode)) ||
                                 (node.operation == Operation::Intersection &&
                                  std::find(operands.begin(), operands.end(), kNoNode) != operands.end());
            left[id] = node.operation == Operation::Leaf ? joiner.like_leaf(tree, id)
                       : emptied                         ? kNoNode
                                                         : joiner.like(tree, id, operands);
            continue;
        }
        switch (node.operation) {
            case Operation::Difference:
                left[id] = operands.empty() ? kNoNode : operands[0];
                break;
            case Operation::Intersection:
            case Operation::Transform:
            case Operation::Color:
                left[id] = joiner.combine(Operation::Group, operands);
                break;
            case Operation::Group:
            case Operation::Union:
            case Operation::Leaf:
            case Operation::Mesh:
                break;
        }
    }
    return joiner.finish(tree.root() == kNoNode ? std::vector<NodeId>{} : std::vector{left[tree.root()]});
}

}  // namespace csg
