#include "ui/pipeline/editing/scale_leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace ui {

namespace {

constexpr double kWritten = 0.1 * kNearEnough;  ///< Of numbers that are put in.

/// What tells how large a leaf is in the world: along its axes, and at both ends of a cylinder.
struct Extents {
    glm::dvec3 sizes{0.0};
    double upper = 0;  ///< Radius of a cylinder; sizes has the lower one.
};

/// Of shapes whose own size is not known: of a unit, which is then the same for all that have that shape.
Extents extents_of(const csg::Tree& tree, const csg::LeafInstance& leaf) {
    const glm::dvec3 columns(glm::length(glm::dvec3(leaf.to_world[0])), glm::length(glm::dvec3(leaf.to_world[1])),
                             glm::length(glm::dvec3(leaf.to_world[2])));
    if (tree.node(leaf.node).operation == csg::Operation::Leaf) {
        const csg::LeafShape& shape = tree.shape(leaf.node);
        if (const auto* const cube = std::get_if<csg::Cube>(&shape)) {
            return {columns * cube->size, 0};
        }
        if (const auto* const sphere = std::get_if<csg::Sphere>(&shape)) {
            return {columns * sphere->radius, 0};
        }
        if (const auto* const cylinder = std::get_if<csg::Cylinder>(&shape)) {
            return {columns * glm::dvec3(cylinder->radius1, cylinder->radius1, cylinder->height),
                    columns.x * cylinder->radius2};
        }
    }
    return {columns, 0};
}

/// Of one kind, and in the same place in their own coordinates but for their sizes.
bool of_one_kind(const csg::Tree& a, const csg::LeafInstance& in_a, const csg::Tree& b, const csg::LeafInstance& in_b) {
    const csg::Node &node_a = a.node(in_a.node), &node_b = b.node(in_b.node);
    if (node_a.hash == node_b.hash) {
        return true;
    }
    if (node_a.operation != csg::Operation::Leaf || node_b.operation != csg::Operation::Leaf) {
        return false;
    }
    const csg::LeafShape &x = a.shape(in_a.node), &y = b.shape(in_b.node);
    if (const auto* const p = std::get_if<csg::Cube>(&x), * const q = std::get_if<csg::Cube>(&y); p && q) {
        return p->center == q->center;
    }
    if (const auto* const p = std::get_if<csg::Sphere>(&x), * const q = std::get_if<csg::Sphere>(&y); p && q) {
        return p->fineness == q->fineness;
    }
    const auto *const p = std::get_if<csg::Cylinder>(&x), *const q = std::get_if<csg::Cylinder>(&y);
    return p != nullptr && q != nullptr && p->center == q->center && p->fineness == q->fineness;
}

glm::dmat3 directions(const glm::dmat4& to_world) {
    glm::dmat3 columns(to_world);
    for (int i = 0; i < 3; ++i) {
        columns[i] = glm::normalize(columns[i]);
    }
    return columns;
}

}  // namespace

std::vector<MoveWay> ways_to_scale(const csg::Tree& tree, const csg::Scene& scene,
                                   const csg::scad::LoadedProgram& program, const std::string& text, csg::LeafId leaf,
                                   const glm::dvec3& factors, const TreeOfText& tree_of, const std::stop_token& stop,
                                   Ways wanted) {
    const csg::LeafInstance& before = scene.leaves[leaf];
    if (!(factors.x > 0 && factors.y > 0 && factors.z > 0) ||
        std::abs(glm::determinant(glm::dmat3(before.to_world))) < 1e-12) {
        return {};
    }
    const glm::dmat4 sizes(factors.x, 0, 0, 0, 0, factors.y, 0, 0, 0, 0, factors.z, 0, 0, 0, 0, 1);
    const glm::dmat4 target = before.to_world * sizes;
    Extents wanted_extents = extents_of(tree, before);
    wanted_extents.sizes *= factors;
    wanted_extents.upper *= factors.x;
    EditGoal goal;
    goal.left = [&](const csg::Tree& changed, const csg::LeafInstance& now) -> std::optional<glm::dvec3> {
        if (!of_one_kind(changed, now, tree, before)) {
            return std::nullopt;
        }
        const Extents there = extents_of(changed, now);
        glm::dvec3 left = wanted_extents.sizes - there.sizes;
        // A cylinder's two radii and its height are three numbers, where its axes across are scaled alike.
        if (wanted_extents.upper > 0 && std::abs(left.x - left.y) <= kNearEnough) {
            left.y = wanted_extents.upper - there.upper;
        }
        return left;
    };
    goal.reached = [&](const csg::Tree& changed, const csg::LeafInstance& now) {
        if (!of_one_kind(changed, now, tree, before)) {
            return false;
        }
        const Extents there = extents_of(changed, now);
        const glm::dvec3 left = glm::abs(wanted_extents.sizes - there.sizes);
        return std::max({left.x, left.y, left.z, std::abs(wanted_extents.upper - there.upper)}) <= kNearEnough &&
               apart(glm::dmat4(directions(now.to_world)), glm::dmat4(directions(target))) <= kNearEnough &&
               glm::length(glm::dvec3(now.to_world[3] - target[3])) <= kNearEnough;
    };
    goal.put = [&](const glm::dmat4& to_world) -> std::optional<std::pair<std::string, std::string>> {
        const glm::dmat4 here = glm::inverse(to_world) * target * glm::inverse(before.to_world) * to_world;
        const glm::dvec3 diagonal(here[0][0], here[1][1], here[2][2]), by(here[3]);
        const glm::dmat3 even(diagonal.x, 0, 0, 0, diagonal.y, 0, 0, 0, diagonal.z);
        if (apart(glm::dmat4(glm::dmat3(here)), glm::dmat4(even)) > kWritten) {
            return std::nullopt;  // Its axes are not those of that place.
        }
        const std::string scale = "scale(" + short_vector(diagonal, kWritten) + ") ";
        return glm::length(by) <= kWritten ? std::pair(scale, std::string("scale()"))
                                           : std::pair("translate(" + short_vector(by, kWritten) + ") " + scale,
                                                       std::string("translate() and scale()"));
    };
    return edit_ways(tree, scene, program, text, leaf, goal, tree_of, stop, wanted);
}

}  // namespace ui
