#include "ui/pipeline/editing/move_leaf.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <variant>

#include <fmt/format.h>

#include "csg/solid/solid.h"

namespace ui {

namespace {

constexpr double kDegrees = 57.29577951308232;
constexpr double kTolerance = 0.1 * kNearEnough;  ///< Of numbers that are written.

std::string vector_text(const glm::dvec3& v) {
    return short_vector(v, kTolerance);
}

bool same_shape(const csg::Tree& a, csg::NodeId in_a, const csg::Tree& b, csg::NodeId in_b) {
    return a.node(in_a).hash == b.node(in_b).hash;
}

/// A vector along the axis as long as the angle in radians.
glm::dvec3 rotation_vector(const glm::dmat3& rotation) {
    const glm::dquat q = glm::normalize(glm::quat_cast(rotation));
    const glm::dvec3 v(q.x, q.y, q.z);
    const double sine = glm::length(v);
    const double angle = 2 * std::atan2(sine, std::abs(q.w));
    return sine > 0 ? v * ((q.w < 0 ? -angle : angle) / sine) : v * 2.0;
}

/// Degrees about x, then y, then z, as rotate() takes them.
glm::dvec3 rotate_angles(const glm::dmat3& r) {
    const double y = std::asin(std::clamp(-r[0][2], -1.0, 1.0));
    if (std::abs(r[0][2]) > 1 - 1e-12) {
        return glm::dvec3(std::atan2(-r[2][1], r[1][1]), y, 0) * kDegrees;
    }
    return glm::dvec3(std::atan2(r[1][2], r[2][2]), y, std::atan2(r[0][1], r[0][0])) * kDegrees;
}

}  // namespace

std::optional<glm::dvec2> leaf_extent(const csg::Tree& tree, csg::NodeId id, int axis) {
    const csg::Node& node = tree.node(id);
    if (node.operation == csg::Operation::Mesh) {
        const auto* const extrude = std::get_if<csg::LinearExtrude>(&tree.mesh(id));
        if (extrude == nullptr || axis != 2 || extrude->has_direction) {
            return std::nullopt;
        }
        return extrude->center ? glm::dvec2(-0.5, 0.5) * extrude->height : glm::dvec2(0, extrude->height);
    }
    if (node.operation != csg::Operation::Leaf) {
        return std::nullopt;
    }
    // Round ones by their radius: their points do not all lie where they touch their box.
    const csg::LeafShape& shape = tree.shape(id);
    if (const auto* const sphere = std::get_if<csg::Sphere>(&shape)) {
        return glm::dvec2(-1, 1) * sphere->radius;
    }
    if (const auto* const cylinder = std::get_if<csg::Cylinder>(&shape); cylinder != nullptr && axis < 2) {
        return glm::dvec2(-1, 1) * std::max(cylinder->radius1, cylinder->radius2);
    }
    const auto solid = csg::solid::make_solid(shape);
    if (solid == nullptr || solid->points.empty()) {
        return std::nullopt;
    }
    glm::dvec2 ends(solid->points[0][axis]);
    for (const glm::dvec3& p : solid->points) {
        ends = {std::min(ends.x, p[axis]), std::max(ends.y, p[axis])};
    }
    return ends;
}

std::vector<MoveWay> ways_to_move(const csg::Tree& tree, const csg::Scene& scene,
                                  const csg::scad::LoadedProgram& program, const std::string& text, csg::LeafId leaf,
                                  const glm::dvec3& by, const TreeOfText& tree_of, const std::stop_token& stop,
                                  Ways wanted) {
    const csg::LeafInstance& before = scene.leaves[leaf];
    glm::dmat4 target = before.to_world;
    target[3] += glm::dvec4(by, 0);
    EditGoal goal;
    goal.left = [&](const csg::Tree&, const csg::LeafInstance& now) {
        return std::optional(glm::dvec3(target[3] - now.to_world[3]));
    };
    goal.reached = [&](const csg::Tree& changed, const csg::LeafInstance& now) {
        return same_shape(changed, now.node, tree, before.node) && apart(now.to_world, target) <= kNearEnough;
    };
    goal.put = [&](const glm::dmat4& to_world) {
        const glm::dvec3 here = glm::inverse(glm::dmat3(to_world)) * by;
        return std::optional(std::pair(fmt::format("translate({}) ", vector_text(here)), std::string("translate()")));
    };
    return edit_ways(tree, scene, program, text, leaf, goal, tree_of, stop, wanted);
}

std::vector<MoveWay> ways_to_turn(const csg::Tree& tree, const csg::Scene& scene,
                                  const csg::scad::LoadedProgram& program, const std::string& text, csg::LeafId leaf,
                                  const glm::dvec3& turn, const TreeOfText& tree_of, const std::stop_token& stop,
                                  Ways wanted) {
    const csg::LeafInstance& before = scene.leaves[leaf];
    const double angle = glm::length(turn);
    if (!(angle > 0)) {
        return {};
    }
    const glm::dmat4 rotation = glm::mat4_cast(glm::angleAxis(angle / kDegrees, turn / angle));
    glm::dmat4 target = rotation * before.to_world;
    target[3] = before.to_world[3];
    EditGoal goal;
    goal.left = [&](const csg::Tree&, const csg::LeafInstance& now) -> std::optional<glm::dvec3> {
        const glm::dmat3 linear(now.to_world);
        return std::abs(glm::determinant(linear)) > 1e-12
                   ? std::optional(rotation_vector(glm::dmat3(target) * glm::inverse(linear)))
                   : std::nullopt;
    };
    goal.reached = [&](const csg::Tree& changed, const csg::LeafInstance& now) {
        return same_shape(changed, now.node, tree, before.node) && apart(now.to_world, target) <= kNearEnough;
    };
    goal.put = [&](const glm::dmat4& to_world) -> std::optional<std::pair<std::string, std::string>> {
        if (std::abs(glm::determinant(glm::dmat3(before.to_world))) < 1e-12) {
            return std::nullopt;
        }
        const glm::dmat4 here = glm::inverse(to_world) * target * glm::inverse(before.to_world) * to_world;
        const glm::dmat3 linear(here);
        if (apart(glm::dmat4(glm::transpose(linear) * linear), glm::dmat4(1.0)) > kTolerance) {
            return std::nullopt;  // Behind a scale() that is not even it is no rotation.
        }
        const glm::dvec3 by(here[3]);
        const std::string rotate = fmt::format("rotate({}) ", vector_text(rotate_angles(linear)));
        return glm::length(by) <= kTolerance ? std::pair(rotate, std::string("rotate()"))
                                             : std::pair(fmt::format("translate({}) {}", vector_text(by), rotate),
                                                         std::string("translate() and rotate()"));
    };
    return edit_ways(tree, scene, program, text, leaf, goal, tree_of, stop, wanted);
}

std::vector<MoveWay> ways_to_stretch(const csg::Tree& tree, const csg::Scene& scene,
                                     const csg::scad::LoadedProgram& program, const std::string& text, csg::LeafId leaf,
                                     int axis, bool upper, double by, const TreeOfText& tree_of,
                                     const std::stop_token& stop, Ways wanted) {
    const csg::LeafInstance& before = scene.leaves[leaf];
    const double scale = glm::length(glm::dvec3(before.to_world[axis]));
    if (!(scale > 0)) {
        return {};
    }
    const glm::dvec3 outwards = glm::dvec3(before.to_world[axis]) / (upper ? scale : -scale);
    // Where that side is, along its normal; of what moves aside within its plane nothing.
    const auto side = [=](const csg::Tree& of, const csg::LeafInstance& now) -> std::optional<double> {
        const auto ends = leaf_extent(of, now.node, axis);
        if (!ends) {
            return std::nullopt;
        }
        const glm::dvec4 middle = now.to_world[axis] * (upper ? ends->y : ends->x) + now.to_world[3];
        return glm::dot(glm::dvec3(middle), outwards);
    };
    const auto first = side(tree, before);
    if (!first) {
        return {};
    }
    EditGoal goal;
    goal.left = [&](const csg::Tree& changed, const csg::LeafInstance& now) -> std::optional<glm::dvec3> {
        // What only moves it is no way to stretch it.
        if (&changed != &tree && same_shape(changed, now.node, tree, before.node)) {
            return std::nullopt;
        }
        const auto there = side(changed, now);
        return there ? std::optional(glm::dvec3(*first + by - *there, 0, 0)) : std::nullopt;
    };
    goal.reached = [&](const csg::Tree& changed, const csg::LeafInstance& now) {
        const auto left = goal.left(changed, now);
        return left && std::abs(left->x) <= kNearEnough &&
               apart(glm::dmat4(glm::dmat3(now.to_world)), glm::dmat4(glm::dmat3(before.to_world))) <= kNearEnough;
    };
    return edit_ways(tree, scene, program, text, leaf, goal, tree_of, stop, wanted);
}

}  // namespace ui
