#include "ui/pipeline/moving_model.h"

#include <algorithm>
#include <utility>

namespace ui {

namespace {

/// Up to where their leaves are.
bool same_expressions(const csg::Scene& a, const csg::Scene& b) {
    const auto same = [](const csg::Expression& x, const csg::Expression& y) {
        return x.kind == y.kind && x.leaf == y.leaf && x.first_child == y.first_child && x.child_count == y.child_count;
    };
    const auto same_part = [](const csg::Part& x, const csg::Part& y) {
        return x.kind == y.kind && x.first_expression == y.first_expression && x.root == y.root &&
               x.first_leaf == y.first_leaf && x.leaf_count == y.leaf_count && x.name == y.name && x.color == y.color &&
               x.hidden == y.hidden;
    };
    return std::equal(a.expressions.begin(), a.expressions.end(), b.expressions.begin(), b.expressions.end(), same) &&
           a.expression_children == b.expression_children &&
           std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(), same_part);
}

/// By which coordinates are rounded.
double reach_of(const csg::solid::Geometry& geometry) {
    double reach = 0;
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        if (!leaf.box.empty()) {
            const glm::dvec3 far = glm::max(glm::abs(leaf.box.lo), glm::abs(leaf.box.hi));
            reach = std::max({reach, far.x, far.y, far.z});
        }
    }
    return reach;
}

}  // namespace

bool same_content(const csg::Tree& a, const csg::Tree& b) {
    const bool empty = a.root() == csg::kNoNode || b.root() == csg::kNoNode;
    return empty ? a.root() == b.root() : a.node(a.root()).hash == b.node(b.root()).hash;
}

MovingModel::MovingModel(const Model& model, csg::Showing showing, csg::PartRule rule)
    : showing_(showing),
      rule_(std::move(rule)),
      box_(model.geometry.box),
      reach_(reach_of(model.geometry)),
      edited_(model) {}

std::optional<std::size_t> leaves_moved(const Model& model, const csg::Tree& tree, const csg::Scene& scene) {
    const csg::Scene& own = model.scene;
    const bool alike = scene.leaves.size() == own.leaves.size() && same_expressions(scene, own) &&
                       std::equal(scene.leaves.begin(), scene.leaves.end(), own.leaves.begin(),
                                  [&](const csg::LeafInstance& now, const csg::LeafInstance& before) {
                                      return now.color == before.color && now.part == before.part &&
                                             tree.node(now.node).hash == model.tree->node(before.node).hash;
                                  });
    if (!alike) {
        return std::nullopt;
    }
    std::size_t moved = 0;
    for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
        moved += scene.leaves[leaf].to_world != own.leaves[leaf].to_world ? 1 : 0;
    }
    return moved;
}

bool MovingModel::follow(const csg::Tree& tree) {
    moved_ = 0;
    const csg::Scene scene = csg::make_scene(tree, showing_, rule_);
    if (!leaves_moved(edited_.model(), tree, scene)) {
        return false;
    }
    for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
        if (scene.leaves[leaf].to_world != edited_.model().scene.leaves[leaf].to_world) {
            edited_.scene().move(leaf, scene.leaves[leaf].to_world);
            ++moved_;
        }
    }
    change_ = edited_.commit();
    const csg::Box& box = edited_.model().geometry.box;
    return change_.failures.empty() && !change_.structure && box.lo == box_.lo && box.hi == box_.hi &&
           reach_of(edited_.model().geometry) == reach_;
}

}  // namespace ui
