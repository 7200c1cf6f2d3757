#include "ui/pipeline/inspection/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ui {

namespace {

/// More than what a number loses as a float, as a share of it.
constexpr double kLost = std::numeric_limits<float>::epsilon();

/// Halves of the boxes by the middle of the longest side of what they fill.
std::size_t halve(std::span<std::uint32_t> ids, std::span<const csg::Box> boxes) {
    csg::Box all;
    for (const std::uint32_t id : ids) {
        all = csg::enclose(all, boxes[id]);
    }
    const glm::dvec3 size = all.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = ids.size() / 2;
    std::nth_element(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(middle), ids.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return boxes[a].lo[axis] + boxes[a].hi[axis] < boxes[b].lo[axis] + boxes[b].hi[axis];
                     });
    return middle;
}

}  // namespace

RayTree::Ray::Ray(const csg::Box& from, const glm::dvec3& direction, double length)
    : most(std::nextafter(static_cast<float>(length), std::numeric_limits<float>::infinity())) {
    // Not infinite, so that a ray that lies just in a face of a box is between its faces.
    constexpr double kLeast = 1e-30;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = direction[axis];
        below[static_cast<std::size_t>(axis)] = static_cast<float>(from.lo[axis] - kLost * std::abs(from.lo[axis]));
        above[static_cast<std::size_t>(axis)] = static_cast<float>(from.hi[axis] + kLost * std::abs(from.hi[axis]));
        inverse[static_cast<std::size_t>(axis)] =
            static_cast<float>(1 / (std::abs(d) < kLeast ? std::copysign(kLeast, d) : d));
    }
}

RayTree::RayTree(std::span<const csg::Box> boxes) {
    if (boxes.empty()) {
        return;
    }
    std::vector<std::uint32_t> ids(boxes.size());
    std::iota(ids.begin(), ids.end(), 0U);
    struct Task {
        std::uint32_t node;
        std::span<std::uint32_t> ids;
    };
    std::vector<Task> tasks{{0, ids}};
    nodes_.emplace_back();
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        std::array<std::span<std::uint32_t>, 4> groups{};
        if (task.ids.size() <= 4) {
            for (std::size_t i = 0; i < task.ids.size(); ++i) {
                groups[i] = task.ids.subspan(i, 1);
            }
        } else {
            const std::size_t middle = halve(task.ids, boxes);
            const auto left = task.ids.first(middle), right = task.ids.subspan(middle);
            const std::size_t in_left = halve(left, boxes), in_right = halve(right, boxes);
            groups = {left.first(in_left), left.subspan(in_left), right.first(in_right), right.subspan(in_right)};
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (groups[i].empty()) {
                continue;
            }
            csg::Box box;
            for (const std::uint32_t id : groups[i]) {
                box = csg::enclose(box, boxes[id]);
            }
            std::uint32_t child = kIsBox | groups[i].front();
            if (groups[i].size() > 1) {
                child = static_cast<std::uint32_t>(nodes_.size());
                nodes_.emplace_back();
                tasks.push_back({child, groups[i]});
            }
            Node& node = nodes_[task.node];
            node.children |= 1U << i;
            node.child[i] = child;
            for (int axis = 0; axis < 3; ++axis) {
                node.lo[static_cast<std::size_t>(axis)][i] =
                    static_cast<float>(box.lo[axis] - kLost * std::abs(box.lo[axis]));
                node.hi[static_cast<std::size_t>(axis)][i] =
                    static_cast<float>(box.hi[axis] + kLost * std::abs(box.hi[axis]));
            }
        }
    }
}

}  // namespace ui
