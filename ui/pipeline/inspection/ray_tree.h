// What a ray meets among many boxes, for rays by the million: a tree of four-fold nodes in single precision.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "csg/tree/box.h"

namespace ui {

/// Boxes are rounded outwards, and the four of a node are asked at once (Wald, Benthin, Boulos: Getting rid of packets,
/// 2008). So more boxes may be visited than the ray meets, never fewer.
class RayTree {
  public:
    explicit RayTree(std::span<const csg::Box> boxes);

    /// Calls `visit(i)` for each box that the ray meets before `most` times its direction, in no order that means
    /// anything, but the same each time.
    template <typename Visit>
    void along(const glm::dvec3& origin, const glm::dvec3& direction, double most, Visit&& visit) const {
        along(csg::Box{origin, origin}, direction, most, visit);
    }
    /// The same for all rays of that direction from points of a box. `visit` may give whether to go on.
    template <typename Visit>
    void along(const csg::Box& origins, const glm::dvec3& direction, double most, Visit&& visit) const {
        if (nodes_.empty()) {
            return;
        }
        const Ray ray(origins, direction, most);
        std::array<std::uint32_t, kMostWaiting> waiting;
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const Node& node = nodes_[waiting[--count]];
            for (unsigned met = meets(node, ray); met != 0; met &= met - 1) {
                const std::uint32_t child = node.child[static_cast<std::size_t>(std::countr_zero(met))];
                if ((child & kIsBox) != 0) {
                    if constexpr (std::is_same_v<decltype(visit(child)), bool>) {
                        if (!visit(child & ~kIsBox)) {
                            return;
                        }
                    } else {
                        visit(child & ~kIsBox);
                    }
                } else {
                    waiting[count++] = child;
                }
            }
        }
    }

  private:
    static constexpr std::uint32_t kIsBox = std::uint32_t{1} << 31U;
    /// Three of each node on the way down, of at most 16 levels of four-fold nodes.
    static constexpr std::size_t kMostWaiting = 64;

    using Four __attribute__((vector_size(16))) = float;
    struct Node {
        std::array<Four, 3> lo{}, hi{};  ///< By axis and child.
        std::array<std::uint32_t, 4> child{};
        unsigned children = 0;  ///< A bit for each that is there.
    };
    struct Ray {
        Ray(const csg::Box& from, const glm::dvec3& direction, double length);
        std::array<float, 3> below, above, inverse;  ///< All origins lie between the first two.
        float most;
    };

    /// A bit for each child.
    static unsigned meets(const Node& node, const Ray& ray) {
        Four from{}, to = Four{} + ray.most;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Four a = (node.lo[axis] - ray.above[axis]) * ray.inverse[axis];
            const Four b = (node.hi[axis] - ray.below[axis]) * ray.inverse[axis];
            const Four near = a < b ? a : b, far = a < b ? b : a;
            from = near > from ? near : from;
            to = far < to ? far : to;
        }
        constexpr float kRoom = 1 + 8 * std::numeric_limits<float>::epsilon();  // Rounding of differences and products.
        const auto met = from <= to * kRoom;
        const unsigned bits = (met[0] & 1) | (met[1] & 2) | (met[2] & 4) | (met[3] & 8);
        return bits & node.children;
    }

    std::vector<Node> nodes_;  ///< The root first.
};

}  // namespace ui
