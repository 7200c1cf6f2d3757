#include "ui/pipeline/inspection/effects.h"

#include <algorithm>

namespace ui {

namespace {

using csg::Expression;
using csg::ExpressionKind;

/// What is subtracted by itself, or as an operand of unions only: looked at where it is subtracted. The same for what
/// is united: of unions within unions, in the outermost.
bool is_looked_at_above(const ExpressionLinks& links, std::uint32_t united) {
    const std::uint32_t parent = links.parent[united];
    if (parent == ExpressionLinks::kNone) {
        return false;
    }
    const ExpressionKind kind = links.scene.expressions[parent].kind;
    return kind == ExpressionKind::Union || (kind == ExpressionKind::Difference && links.first[united] == 0);
}

}  // namespace

void Effects::look(const PointValues& values) {
    const ExpressionLinks& links = values.links();
    const csg::Scene& scene = links.scene;
    const auto matters_down = [&](std::uint64_t index) {
        auto i = static_cast<std::uint32_t>(index);
        for (matters[i] = 1; scene.expressions[i].kind == ExpressionKind::Union && values.node(i).true_children == 1;) {
            i = static_cast<std::uint32_t>(values.node(i).sum);
            matters[i] = 1;
        }
    };
    for (const std::uint32_t i : values.touched()) {
        const PointValues::Node& node = values.node(i);
        const Expression& e = scene.expressions[i];
        holds[i] = holds[i] != 0 || node.value ? 1 : 0;
        const auto children = scene.children(e);
        if (e.kind == ExpressionKind::Union && node.true_children == 1 && !is_looked_at_above(links, i)) {
            matters_down(node.sum);
        } else if (e.kind == ExpressionKind::Difference && node.first && node.true_children == 2) {
            matters_down(node.sum - children[0]);
        } else if (e.kind == ExpressionKind::Intersection && node.true_children + 1 == e.child_count) {
            for (const std::uint32_t child : children) {
                matters[child] = matters[child] != 0 || !values.value(child) ? 1 : 0;
            }
        }
    }
    if (values.parts().size() == 1) {
        alone[values.parts().front()] = 1;
    }
}

void Effects::add(const Effects& other) {
    const auto either = [](std::vector<char>& into, const std::vector<char>& from) {
        std::transform(into.begin(), into.end(), from.begin(), into.begin(),
                       [](char a, char b) { return static_cast<char>(a | b); });
    };
    either(holds, other.holds);
    either(matters, other.matters);
    either(alone, other.alone);
}

bool Effects::idle(const ExpressionLinks& links, std::uint32_t expression) const {
    const std::uint32_t parent = links.parent[expression];
    if (parent == ExpressionLinks::kNone || links.scene.expressions[parent].child_count == 1) {
        return false;
    }
    const bool first =
        links.scene.expressions[parent].kind == ExpressionKind::Difference && links.first[expression] != 0;
    return !first && matters[expression] == 0;
}

bool Effects::emptied(const ExpressionLinks& links, std::uint32_t expression) const {
    const Expression& e = links.scene.expressions[expression];
    const auto children = links.scene.children(e);
    const auto held = [&](std::uint32_t child) { return holds[child] != 0; };
    if (holds[expression] != 0 || children.size() < 2) {
        return false;
    }
    return (e.kind == ExpressionKind::Intersection && std::all_of(children.begin(), children.end(), held)) ||
           (e.kind == ExpressionKind::Difference && held(children[0]));
}

bool is_subtracted(const ExpressionLinks& links, std::uint32_t expression) {
    for (std::uint32_t i = expression; links.parent[i] != ExpressionLinks::kNone; i = links.parent[i]) {
        const ExpressionKind kind = links.scene.expressions[links.parent[i]].kind;
        if (kind != ExpressionKind::Union) {
            return kind == ExpressionKind::Difference && links.first[i] == 0;
        }
    }
    return false;
}

}  // namespace ui
