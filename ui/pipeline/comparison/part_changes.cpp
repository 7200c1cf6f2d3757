#include "ui/pipeline/comparison/part_changes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csg/reference/boolean.h"
#include "csg/tree/changes.h"
#include "csg/tree/scene.h"
#include "ui/pipeline/mesh/exact_operations.h"
#include "ui/pipeline/model.h"

namespace ui {

namespace {

using csg::PartId;

/// Appends a scene's part; `nodes`: what its nodes are in the tree of `to`.
void append(csg::Scene& to, const csg::Scene& from, const csg::Part& part, const csg::Tree& tree,
            const std::vector<csg::NodeId>& nodes) {
    const auto leaf_shift = static_cast<std::uint32_t>(to.leaves.size()) - part.first_leaf;
    const auto shift = static_cast<std::uint32_t>(to.expressions.size()) - part.first_expression;
    for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
        csg::LeafInstance instance = from.leaves[leaf];
        instance.node = nodes[instance.node];
        instance.where = tree.node(instance.node).where;
        instance.occurrence = csg::kNoOccurrence;
        instance.part = static_cast<PartId>(to.parts.size());
        to.leaves.push_back(std::move(instance));
    }
    for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
        csg::Expression e = from.expressions[i];
        const auto children = from.children(e);
        e.leaf += leaf_shift;
        e.occurrence = csg::kNoOccurrence;
        e.first_child = static_cast<std::uint32_t>(to.expression_children.size());
        for (const std::uint32_t child : children) {
            to.expression_children.push_back(child + shift);
        }
        to.expressions.push_back(e);
    }
    csg::Part moved = part;
    moved.first_expression += shift;
    moved.root += shift;
    moved.first_leaf += leaf_shift;
    to.parts.push_back(std::move(moved));
}

/// The parts of both versions in one scene, so that their faces have the planes of one table.
class Versions {
  public:
    Versions(const csg::Tree& before, const csg::Tree& after, const csg::PartRule& rule, std::stop_token stop)
        : joined_(csg::joined(before, after)), stop_(std::move(stop)) {
        const auto add = [&](const csg::Tree& tree, const std::vector<csg::NodeId>& nodes) {
            const csg::Scene scene = csg::make_scene(tree, csg::Showing::Result, rule);
            for (const csg::Part& part : scene.parts) {
                append(scene_, scene, part, joined_.tree, nodes);
            }
            return scene_.parts.size();
        };
        first_after_ = add(before, joined_.first);
        add(after, joined_.second);
        csg::solid::SolidCache cache(exact_operations());
        geometry_ = csg::solid::place(joined_.tree, scene_, cache, 1, stop_);
        if (!geometry_.failures.empty()) {
            throw ModelError(fmt::format("{}", fmt::join(geometry_.failures, "\n")));
        }
    }

    [[nodiscard]] std::size_t count() const { return scene_.parts.size(); }
    /// Parts from here on are of the later version.
    [[nodiscard]] std::size_t first_after() const { return first_after_; }
    [[nodiscard]] const std::string& name(std::size_t part) const { return scene_.parts[part].name; }

    /// Is the one written as the other, and where it is?
    [[nodiscard]] bool alike(std::size_t a, std::size_t b) const {
        const csg::Part &p = scene_.parts[a], &q = scene_.parts[b];
        if (p.leaf_count != q.leaf_count || p.root - p.first_expression != q.root - q.first_expression) {
            return false;
        }
        for (csg::LeafId i = 0; i < p.leaf_count; ++i) {
            const csg::LeafInstance &x = scene_.leaves[p.first_leaf + i], &y = scene_.leaves[q.first_leaf + i];
            if (joined_.tree.node(x.node).hash != joined_.tree.node(y.node).hash || x.to_world != y.to_world) {
                return false;
            }
        }
        for (std::uint32_t i = 0; i <= p.root - p.first_expression; ++i) {
            const csg::Expression &x = scene_.expressions[p.first_expression + i],
                                  &y = scene_.expressions[q.first_expression + i];
            const auto same_child = [&](std::uint32_t c, std::uint32_t d) {
                return c - p.first_expression == d - q.first_expression;
            };
            const auto children = scene_.children(x), others = scene_.children(y);
            if (x.kind != y.kind ||
                (x.kind == csg::ExpressionKind::Leaf && x.leaf - p.first_leaf != y.leaf - q.first_leaf) ||
                !std::equal(children.begin(), children.end(), others.begin(), others.end(), same_child)) {
                return false;
            }
        }
        return true;
    }

    /// The part, or the part less another.
    [[nodiscard]] MeasuredSolid solid(std::size_t part, std::optional<std::size_t> less) const {
        csg::Scene scene;
        csg::solid::Geometry geometry;
        geometry.planes = geometry_.planes;
        for (const std::size_t id : less ? std::vector{part, *less} : std::vector{part}) {
            const csg::Part& of = scene_.parts[id];
            append(scene, scene_, of, joined_.tree, same_nodes());
            for (csg::LeafId leaf = of.first_leaf; leaf < of.first_leaf + of.leaf_count; ++leaf) {
                geometry.leaves.push_back(geometry_.leaves[leaf]);
                geometry.box = csg::enclose(geometry.box, geometry_.leaves[leaf].box);
            }
        }
        unite_parts(scene);
        const auto found = csg::reference::make_mesh(scene, geometry, {.method = {}, .stop = stop_});
        return found.mesh.empty() ? MeasuredSolid{} : MeasuredSolid{found.facts.volume, found.facts.box};
    }

  private:
    [[nodiscard]] const std::vector<csg::NodeId>& same_nodes() const {
        if (same_nodes_.empty()) {
            for (csg::NodeId node = 0; node < joined_.tree.size(); ++node) {
                same_nodes_.push_back(node);
            }
        }
        return same_nodes_;
    }
    /// Of a scene of two parts one, the first less the second.
    static void unite_parts(csg::Scene& scene) {
        csg::Part all = scene.parts.front();
        all.kind = csg::PartKind::Solid;
        if (scene.parts.size() > 1) {
            csg::Expression difference;
            difference.kind = csg::ExpressionKind::Difference;
            difference.first_child = static_cast<std::uint32_t>(scene.expression_children.size());
            difference.child_count = 2;
            scene.expression_children.insert(scene.expression_children.end(),
                                             {scene.parts[0].root, scene.parts[1].root});
            scene.expressions.push_back(difference);
        }
        all.root = static_cast<std::uint32_t>(scene.expressions.size() - 1);
        all.leaf_count = static_cast<csg::LeafId>(scene.leaves.size());
        for (csg::LeafInstance& leaf : scene.leaves) {
            leaf.part = 0;
        }
        scene.parts = {std::move(all)};
    }

    csg::JoinedTrees joined_;
    std::stop_token stop_;
    csg::Scene scene_;
    csg::solid::Geometry geometry_;
    std::size_t first_after_ = 0;
    mutable std::vector<csg::NodeId> same_nodes_;
};

}  // namespace

const char* name(PartChange::Kind kind) {
    static constexpr std::array<const char*, 4> kNames{"unchanged", "changed", "new", "gone"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::vector<PartChange> part_changes(const csg::Tree& before, const csg::Tree& after, const csg::PartRule& rule,
                                     const std::stop_token& stop) {
    const Versions versions(before, after, rule, stop);
    const std::size_t first = versions.first_after(), count = versions.count();
    constexpr std::size_t kNone = ~std::size_t{0};
    std::vector<std::size_t> match(count, kNone);
    const auto pair_up = [&](const auto& belong) {
        for (std::size_t b = first; b < count; ++b) {
            for (std::size_t a = 0; a < first && match[b] == kNone; ++a) {
                if (match[a] == kNone && belong(a, b)) {
                    match[a] = b;
                    match[b] = a;
                }
            }
        }
    };
    const auto alike = [&](std::size_t a, std::size_t b) { return versions.alike(a, b); };
    const auto named_alike = [&](std::size_t a, std::size_t b) { return versions.name(a) == versions.name(b); };
    pair_up([&](std::size_t a, std::size_t b) { return named_alike(a, b) && alike(a, b); });
    pair_up(alike);
    pair_up(named_alike);

    std::vector<PartChange> changes;
    for (std::size_t b = first; b < count; ++b) {
        PartChange change;
        change.name = versions.name(b);
        const std::size_t a = match[b];
        if (a == kNone) {
            change.kind = PartChange::Kind::New;
            change.added = versions.solid(b, std::nullopt);
        } else {
            change.was = versions.name(a) == change.name ? "" : versions.name(a);
            if (!versions.alike(a, b)) {
                change.added = versions.solid(b, a);
                change.removed = versions.solid(a, b);
                const bool same = change.added.box.empty() && change.removed.box.empty();
                change.kind = same ? PartChange::Kind::Unchanged : PartChange::Kind::Changed;
            }
        }
        changes.push_back(std::move(change));
    }
    for (std::size_t a = 0; a < first; ++a) {
        if (match[a] == kNone) {
            changes.push_back({PartChange::Kind::Gone, versions.name(a), "", {}, versions.solid(a, std::nullopt)});
        }
    }
    return changes;
}

}  // namespace ui
