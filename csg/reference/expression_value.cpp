#include "csg/reference/expression_value.h"

#include <algorithm>

namespace csg::reference {

std::vector<PartId> solid_parts(const Scene& scene) {
    std::vector<PartId> parts;
    for (PartId i = 0; i < scene.parts.size(); ++i) {
        if (scene.parts[i].kind == PartKind::Solid || scene.parts[i].kind == PartKind::Translucent) {
            parts.push_back(i);
        }
    }
    return parts;
}

ExpressionValue::ExpressionValue(const GroupExpression& expression)
    : expression_(expression), states_(expression.nodes.size()) {}

bool ExpressionValue::evaluate(std::uint32_t node) const {
    const State& state = states_[node];
    switch (expression_.nodes[node].kind) {
        case ExpressionKind::Leaf:
        case ExpressionKind::Union:
            return state.entered != 0;
        case ExpressionKind::Intersection:
            return state.entered != 0 && state.entered == expression_.nodes[node].children;
        case ExpressionKind::Difference:
            return state.first && state.entered == 0;
    }
    return false;
}

void ExpressionValue::set(LeafId leaf, bool inside) {
    std::uint32_t node = expression_.leaves[leaf];
    states_[node].entered = inside ? 1 : 0;
    for (;;) {
        const bool value = evaluate(node);
        if (value == states_[node].value) {
            return;
        }
        states_[node].value = value;
        const GroupExpression::Node& e = expression_.nodes[node];
        if (e.parent == GroupExpression::kNone) {
            value_ = value;
            return;
        }
        State& above = states_[e.parent];
        if (e.first && expression_.nodes[e.parent].kind == ExpressionKind::Difference) {
            above.first = value;
        } else {
            above.entered += value ? 1 : ~std::uint32_t{0};
        }
        node = e.parent;
    }
}

LeafId ExpressionValue::owner(std::span<const LeafId> switching) const {
    // Below an odd number of subtractions a node speaks for the solid when it is false.
    const auto speaks = [&](LeafId leaf) {
        for (std::uint32_t i = expression_.leaves[leaf]; i != GroupExpression::kNone; i = expression_.nodes[i].parent) {
            if (states_[i].value == expression_.nodes[i].complement) {
                return false;
            }
        }
        return true;
    };
    const auto found = std::find_if(switching.begin(), switching.end(), speaks);
    return found != switching.end() ? *found : switching.front();
}

}  // namespace csg::reference
