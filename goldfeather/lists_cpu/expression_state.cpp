#include "goldfeather/lists_cpu/expression_state.h"

#include <algorithm>

namespace goldfeather {

namespace {

using csg::Expression;
using csg::ExpressionKind;

/// Whose input an expression is, and whether as its complement.
struct Place {
    std::uint32_t gate = ExpressionTree::kNone;
    bool complement = false;
};

/// Is the expression, or its complement, an AND of what it is made of (with complements where it subtracts)?
bool is_and(const Expression& e, bool complement) {
    return (e.kind == ExpressionKind::Union) == complement;
}

}  // namespace

ExpressionTree::ExpressionTree(const csg::Scene& scene)
    : literals_(scene.leaves.size()), part_count_(scene.parts.size()) {
    std::vector<Place> places(scene.expressions.size());
    std::vector<char> ands;
    const auto add_gate = [&](std::uint32_t parent, csg::PartId part, bool is_and) {
        gates_.push_back({parent, part});
        margins_.push_back(is_and ? 0 : -1);
        ands.push_back(is_and ? 1 : 0);
        return static_cast<std::uint32_t>(gates_.size() - 1);
    };
    const auto add_input = [&](std::uint32_t gate, bool value) {
        margins_[gate] += static_cast<std::int32_t>(value) - static_cast<std::int32_t>(ands[gate]);
    };
    for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
        const csg::Part& part = scene.parts[id];
        // Parents stand behind their children: going backwards, an expression's place is known when it is reached.
        for (std::uint32_t i = part.root + 1; i-- > part.first_expression;) {
            const Expression& e = scene.expressions[i];
            const std::span<const std::uint32_t> children = scene.children(e);
            Place place = places[i];
            const bool conjunction = is_and(e, place.complement);
            const bool root = place.gate == kNone;
            if (root || (children.size() > 1 && conjunction != (ands[place.gate] != 0))) {
                place.gate = add_gate(place.gate, id, children.size() > 1 && conjunction);
            }
            if (e.kind == ExpressionKind::Leaf) {
                literals_[e.leaf] = {place.gate, place.complement};
                add_input(place.gate, place.complement);
            } else if (children.empty()) {  // Never true.
                add_input(place.gate, place.complement);
            }
            for (std::size_t k = 0; k < children.size(); ++k) {
                const bool subtracted = e.kind == ExpressionKind::Difference && k > 0;
                places[children[k]] = {place.gate, place.complement != subtracted};
            }
        }
    }
    for (std::size_t i = gates_.size(); i-- > 0;) {
        if (gates_[i].parent != kNone) {
            add_input(gates_[i].parent, margins_[i] >= 0);
        }
    }
}

void ExpressionState::wait(std::uint32_t gate) {
    if (waiting_[gate] == 0) {
        waiting_[gate] = 1;
        heap_.push_back({gate, margins_[gate] >= 0});
        std::push_heap(heap_.begin(), heap_.end());
    }
}

void ExpressionState::toggle(std::span<const csg::LeafId> leaves, std::vector<csg::PartId>& changed) {
    for (const csg::LeafId leaf : leaves) {
        const ExpressionTree::Literal& literal = tree_.literal(leaf);
        wait(literal.gate);
        margins_[literal.gate] += turn(leaf, literal);
    }
    // Parents stand before their children: when a gate's turn comes, all below it have had theirs.
    while (!heap_.empty()) {
        std::pop_heap(heap_.begin(), heap_.end());
        const Turned turned = heap_.back();
        heap_.pop_back();
        waiting_[turned.gate] = 0;
        const ExpressionTree::Gate& g = tree_.gate(turned.gate);
        const bool value = margins_[turned.gate] >= 0;
        if (value == turned.before) {
            continue;
        }
        if (g.parent == ExpressionTree::kNone) {
            parts_[g.part] = value ? 1 : 0;
            changed.push_back(g.part);
        } else {
            wait(g.parent);
            margins_[g.parent] += value ? 1 : -1;
        }
    }
}

}  // namespace goldfeather
