#include "csg/tree/scene_edit.h"

#include <cassert>
#include <utility>

namespace csg {
namespace {

/// Expressions and their children are stored anew: `at(i)` is the number of expression i from now on.
template <typename At>
void renumber(Scene& scene, PartId part, const At& at) {
    for (PartId id = part; id < scene.parts.size(); ++id) {
        Part& p = scene.parts[id];
        if (id > part) {
            p.first_expression = at(p.first_expression);
        }
        p.root = at(p.root);
    }
    for (std::uint32_t& child : scene.expression_children) {
        child = at(child);
    }
}

/// Numbers of leaves from `from` on change by `step`.
void shift_leaves(Scene& scene, PartId part, LeafId from, int step) {
    const auto shifted = [&](LeafId leaf) { return static_cast<LeafId>(static_cast<int>(leaf) + step); };
    for (Expression& e : scene.expressions) {
        if (e.kind == ExpressionKind::Leaf && e.leaf >= from) {
            e.leaf = shifted(e.leaf);
        }
    }
    for (PartId id = part + 1; id < scene.parts.size(); ++id) {
        scene.parts[id].first_leaf = shifted(scene.parts[id].first_leaf);
    }
    scene.parts[part].leaf_count = shifted(scene.parts[part].leaf_count);
}

}  // namespace

std::vector<char> occurrences_below(const Scene& scene, OccurrenceId occurrence) {
    std::vector<char> below(scene.occurrences.size(), 0);
    for (OccurrenceId id = occurrence; id < below.size(); ++id) {
        const OccurrenceId parent = scene.occurrences[id].parent;
        below[id] = id == occurrence || (parent != kNoOccurrence && below[parent] != 0) ? 1 : 0;
    }
    return below;
}

std::uint32_t expression_at(const Scene& scene, const Site& site) {
    const Part& part = scene.parts[site.part];
    if (site.occurrence == kNoOccurrence) {
        return part.root;
    }
    const std::vector<char> below = occurrences_below(scene, site.occurrence);
    for (std::uint32_t i = part.root + 1; i-- > part.first_expression;) {
        const OccurrenceId own = scene.expressions[i].occurrence;
        if (own != kNoOccurrence && below[own] != 0) {
            return i;
        }
    }
    return kNoExpression;
}

LeafId insert_leaf(Scene& scene, const Site& site, ExpressionKind operation, LeafInstance leaf) {
    const PartId part = site.part;
    const std::uint32_t expression = expression_at(scene, site);
    assert(operation != ExpressionKind::Leaf && expression != kNoExpression);
    LeafId id = scene.parts[part].first_leaf;
    for (std::uint32_t i = expression + 1; i-- > scene.parts[part].first_expression;) {
        if (scene.expressions[i].kind == ExpressionKind::Leaf) {
            id = scene.expressions[i].leaf + 1;
            break;
        }
    }
    shift_leaves(scene, part, id, 1);
    leaf.part = part;
    scene.leaves.insert(scene.leaves.begin() + id, leaf);

    // Behind the expression stand the new leaf and the new whole, which takes its place.
    renumber(scene, part, [&](std::uint32_t i) { return i < expression ? i : i + 2; });
    Expression added, whole;
    added.leaf = id;
    whole.kind = operation;
    whole.first_child = static_cast<std::uint32_t>(scene.expression_children.size());
    whole.child_count = 2;
    whole.occurrence = site.occurrence;
    scene.expression_children.insert(scene.expression_children.end(), {expression, expression + 1});
    scene.expressions.insert(scene.expressions.begin() + expression + 1, {added, whole});
    return id;
}

namespace {

/// Appends the leaves and expressions of parts of another scene to one that is being made.
class PartCopier {
  public:
    PartCopier(const Scene& from, Scene& to) : from_(from), to_(to) {}

    /// Gives the number of the copied root. `look`: null where leaves keep theirs.
    std::uint32_t append(const Part& part, PartId into, const LeafInstance* look) {
        const auto first_leaf = static_cast<LeafId>(to_.leaves.size());
        for (LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
            LeafInstance copy = from_.leaves[leaf];
            copy.part = into;
            if (look != nullptr) {
                copy.color = look->color;
                copy.hatching = look->hatching;
            }
            to_.leaves.push_back(copy);
        }
        const auto first = static_cast<std::uint32_t>(to_.expressions.size());
        for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
            Expression copy = from_.expressions[i];
            copy.leaf = copy.kind == ExpressionKind::Leaf ? copy.leaf - part.first_leaf + first_leaf : copy.leaf;
            copy.first_child = static_cast<std::uint32_t>(to_.expression_children.size());
            for (const std::uint32_t child : from_.children(from_.expressions[i])) {
                to_.expression_children.push_back(child - part.first_expression + first);
            }
            to_.expressions.push_back(copy);
        }
        return static_cast<std::uint32_t>(to_.expressions.size()) - 1;
    }

  private:
    const Scene& from_;
    Scene& to_;
};

}  // namespace

void subtract_part(Scene& scene, PartId tool, std::span<const char> cut) {
    Scene made;
    made.parts = scene.parts;
    made.occurrences = std::move(scene.occurrences);
    made.left_out = std::move(scene.left_out);
    PartCopier copier(scene, made);
    for (PartId id = 0; id < scene.parts.size(); ++id) {
        Part& part = made.parts[id];
        part.first_expression = static_cast<std::uint32_t>(made.expressions.size());
        part.first_leaf = static_cast<LeafId>(made.leaves.size());
        part.root = copier.append(scene.parts[id], id, nullptr);
        if (cut[id] != 0) {
            LeafInstance look;
            look.color = part.color;
            look.hatching = 1;
            const std::uint32_t subtracted = copier.append(scene.parts[tool], id, &look);
            Expression whole;
            whole.kind = ExpressionKind::Difference;
            whole.first_child = static_cast<std::uint32_t>(made.expression_children.size());
            whole.child_count = 2;
            made.expression_children.insert(made.expression_children.end(), {part.root, subtracted});
            part.root = static_cast<std::uint32_t>(made.expressions.size());
            made.expressions.push_back(whole);
        }
        part.leaf_count = static_cast<LeafId>(made.leaves.size()) - part.first_leaf;
    }
    scene = std::move(made);
}

void erase_leaf(Scene& scene, LeafId inserted) {
    const PartId part = scene.leaves[inserted].part;
    std::uint32_t at = scene.parts[part].first_expression;
    while (scene.expressions[at].kind != ExpressionKind::Leaf || scene.expressions[at].leaf != inserted) {
        ++at;
    }
    // Before it stands what it was put to, behind it the whole.
    const std::uint32_t first = scene.expressions[at + 1].first_child;
    assert(scene.expression_children[first] == at - 1 && scene.expression_children[first + 1] == at);
    scene.expression_children.erase(scene.expression_children.begin() + first,
                                    scene.expression_children.begin() + first + 2);
    scene.expressions.erase(scene.expressions.begin() + at, scene.expressions.begin() + at + 2);
    for (Expression& e : scene.expressions) {
        if (e.first_child > first) {
            e.first_child -= 2;
        }
    }
    renumber(scene, part, [&](std::uint32_t i) { return i < at ? i : i - 2; });
    scene.leaves.erase(scene.leaves.begin() + inserted);
    shift_leaves(scene, part, inserted, -1);
}

}  // namespace csg
