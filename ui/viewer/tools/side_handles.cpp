#include "ui/viewer/tools/side_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "ui/pipeline/editing/move_leaf.h"

namespace ui {

namespace {

/// Axes of the leaf that grow with one of them, and what their size is called.
struct GrownTogether {
    glm::bvec3 axes{false};
    const char* name = "";
    bool radius = false;  ///< The size is half of the box.
};

GrownTogether grown_with(const csg::Tree& tree, csg::NodeId leaf, int axis) {
    constexpr std::array kNames{"x", "y", "z"};
    GrownTogether own{{axis == 0, axis == 1, axis == 2}, kNames[static_cast<std::size_t>(axis)], false};
    if (tree.node(leaf).operation != csg::Operation::Leaf) {
        own.name = "h";
        return own;
    }
    const csg::LeafShape& shape = tree.shape(leaf);
    if (std::holds_alternative<csg::Sphere>(shape)) {
        return {glm::bvec3(true), "r", true};
    }
    if (std::holds_alternative<csg::Cylinder>(shape)) {
        return axis == 2 ? GrownTogether{{false, false, true}, "h", false}
                         : GrownTogether{{true, true, false}, "r", true};
    }
    return own;
}

}  // namespace

HeldPart SideHandle::moved_out(double by) const {
    HeldPart held = preview;
    const double factor = std::max((extent + by) / extent, 1e-6);
    for (int i = 0; i < 3; ++i) {
        held.scale[i] = grows[i] ? factor : 1;
    }
    held.side = HeldSide{axis, true, by};
    return held;
}

std::vector<SideHandle> side_handles(const csg::Tree& tree, const csg::LeafInstance& leaf,
                                     std::span<const ShapeNumber> numbers) {
    std::vector<SideHandle> handles;
    glm::bvec3 covered(false);
    for (int axis = 0; axis < 3; ++axis) {
        const bool written = std::any_of(numbers.begin(), numbers.end(),
                                         [&](const ShapeNumber& number) { return number.along[axis] != 0; });
        const auto ends = leaf_extent(tree, leaf.node, axis);
        const double scale = glm::length(glm::dvec3(leaf.to_world[axis]));
        const GrownTogether grown = grown_with(tree, leaf.node, axis);
        if (written) {
            covered = glm::bvec3(covered.x || grown.axes.x, covered.y || grown.axes.y, covered.z || grown.axes.z);
        }
        if (covered[axis] || !ends || !(ends->y > ends->x) || !(scale > 0)) {
            continue;
        }
        covered = glm::bvec3(covered.x || grown.axes.x, covered.y || grown.axes.y, covered.z || grown.axes.z);
        const double length = ends->y - ends->x;
        const bool even = std::abs(ends->x + ends->y) <= 1e-9 * length;
        SideHandle handle;
        handle.name = grown.name;
        handle.axis = axis;
        handle.along = glm::dvec3(leaf.to_world[axis]) / scale;
        glm::dvec3 middle(0.0);
        for (int other = 0; other < 3; ++other) {
            const auto across = leaf_extent(tree, leaf.node, other);
            middle[other] = across ? 0.5 * (across->x + across->y) : 0;
        }
        glm::dvec3 side = middle, pivot = middle;
        side[axis] = ends->y;
        pivot[axis] = even ? 0.5 * (ends->x + ends->y) : ends->x;
        handle.at = glm::dvec3(leaf.to_world * glm::dvec4(side, 1.0));
        handle.length = grown.radius ? 0.5 * length : length;
        handle.world_per_unit = even && !grown.radius ? 0.5 * scale : scale;
        handle.preview.occurrence = leaf.occurrence;
        handle.preview.pivot = glm::dvec3(leaf.to_world * glm::dvec4(pivot, 1.0));
        handle.preview.axes = glm::dmat3(leaf.to_world);
        for (int other = 0; other < 3; ++other) {
            handle.preview.axes[other] = glm::normalize(handle.preview.axes[other]);
        }
        handle.grows = grown.axes;
        handle.extent = (side[axis] - pivot[axis]) * scale;
        handles.push_back(std::move(handle));
    }
    return handles;
}

}  // namespace ui
