#include "csg/tree/changes.h"

#include "csg/tree/tree_joiner.h"

namespace csg {
namespace {

constexpr Rgba kSame{0.72F, 0.72F, 0.72F, 0.3F}, kAdded{0.25F, 0.68F, 0.3F, 1}, kRemoved{0.86F, 0.24F, 0.2F, 1};

}  // namespace

Tree changes(const Tree& before, const Tree& after) {
    TreeJoiner joiner;
    const NodeId a = joiner.add_root(before), b = joiner.add_root(after);
    const auto intersection = [&] {
        return a == kNoNode || b == kNoNode ? kNoNode : joiner.combine(Operation::Intersection, {a, b});
    };
    const NodeId same = joiner.colored(kSame, intersection());
    const NodeId added = joiner.colored(kAdded, joiner.combine(Operation::Difference, {b, a}));
    const NodeId removed = joiner.colored(kRemoved, joiner.combine(Operation::Difference, {a, b}));
    return joiner.finish({same, added, removed});
}

Tree less(const Tree& first, const Tree& second) {
    TreeJoiner joiner;
    const NodeId a = joiner.add_root(first), b = joiner.add_root(second);
    return joiner.finish({joiner.combine(Operation::Difference, {a, b})});
}

JoinedTrees joined(const Tree& first, const Tree& second) {
    TreeJoiner joiner;
    JoinedTrees result;
    result.first = joiner.add(first);
    result.second = joiner.add(second);
    const auto root = [](const Tree& tree, const std::vector<NodeId>& nodes) {
        return tree.root() == kNoNode ? kNoNode : nodes[tree.root()];
    };
    result.tree = joiner.finish({root(first, result.first), root(second, result.second)});
    return result;
}

}  // namespace csg
