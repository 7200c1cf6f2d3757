// Pairs of boxes that meet, and what meets a box or a ray.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/disjoint_sets.h"
#include "csg/tree/box.h"

namespace csg::reference {

/// A balanced tree over boxes: halves of the boxes by the middle of the longest side, down to a handful.
class BoxTree {
  public:
    /// Keeps the span, which must outlive the tree.
    explicit BoxTree(std::span<const Box> boxes);

    [[nodiscard]] std::size_t size() const { return boxes_.size(); }

    /// Calls `visit(i, j)` once for each pair of boxes that meet, touching ones too; the same boxes give the same
    /// order.
    template <typename Visit>
    void pairs(Visit&& visit) const {
        within({1, 0, order_.size()}, visit);
    }

    /// Calls `visit(i)` for each box that meets `box`, touching ones too; the same boxes give the same order.
    template <typename Visit>
    void meeting(const Box& box, Visit&& visit) const {
        meeting({1, 0, order_.size()}, box, visit);
    }

    /// Calls `visit(i)` for each box that the ray meets until one gives false, and gives false then. `most`: how many
    /// times its direction the ray is long.
    template <typename Visit>
    bool along(const glm::dvec3& origin, const glm::dvec3& direction, Visit&& visit,
               double most = std::numeric_limits<double>::infinity()) const {
        return along({1, 0, order_.size()}, origin, 1.0 / direction, most, visit);
    }

  private:
    static constexpr std::size_t kMostInLeaf = 8;

    /// A node by its number (children 2 n and 2 n + 1) and its range of `order_`.
    struct Node {
        std::size_t number, from, to;
        [[nodiscard]] Node left() const { return {2 * number, from, (from + to) / 2}; }
        [[nodiscard]] Node right() const { return {2 * number + 1, (from + to) / 2, to}; }
    };

    static bool meet(const Box& a, const Box& b) {
        return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
               b.lo.z <= a.hi.z;
    }
    [[nodiscard]] bool is_leaf(const Node& node) const { return node.number >= first_leaf_; }
    void build(const Node& node);

    template <typename Visit>
    void meeting(const Node& node, const Box& box, Visit& visit) const {
        if (!meet(bounds_[node.number], box)) {
            return;
        }
        if (is_leaf(node)) {
            for (std::size_t i = node.from; i < node.to; ++i) {
                if (meet(boxes_[order_[i]], box)) {
                    visit(order_[i]);
                }
            }
            return;
        }
        meeting(node.left(), box, visit);
        meeting(node.right(), box, visit);
    }

    /// A ray that lies just in a face of the box, across which it has no way (not a number), is between its faces.
    static bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& inverse, double most) {
        const glm::dvec3 a = (box.lo - origin) * inverse, b = (box.hi - origin) * inverse;
        const glm::dvec3 from = glm::min(a, b), to = glm::max(a, b);
        return std::max({0.0, from.x, from.y, from.z}) <= std::min({most, to.x, to.y, to.z});
    }

    template <typename Visit>
    bool along(const Node& node, const glm::dvec3& origin, const glm::dvec3& inverse, double most, Visit& visit) const {
        if (!meets(bounds_[node.number], origin, inverse, most)) {
            return true;
        }
        if (is_leaf(node)) {
            for (std::size_t i = node.from; i < node.to; ++i) {
                if (meets(boxes_[order_[i]], origin, inverse, most) && !visit(order_[i])) {
                    return false;
                }
            }
            return true;
        }
        return along(node.left(), origin, inverse, most, visit) && along(node.right(), origin, inverse, most, visit);
    }

    template <typename Visit>
    void within(const Node& node, Visit& visit) const {
        if (is_leaf(node)) {
            for (std::size_t i = node.from; i < node.to; ++i) {
                one_with(order_[i], i + 1, node.to, visit);
            }
            return;
        }
        within(node.left(), visit);
        within(node.right(), visit);
        between(node.left(), node.right(), visit);
    }

    /// Both nodes are at the same depth.
    template <typename Visit>
    void between(const Node& a, const Node& b, Visit& visit) const {
        if (!meet(bounds_[a.number], bounds_[b.number])) {
            return;
        }
        if (is_leaf(a)) {
            for (std::size_t i = a.from; i < a.to; ++i) {
                if (meet(boxes_[order_[i]], bounds_[b.number])) {
                    one_with(order_[i], b.from, b.to, visit);
                }
            }
            return;
        }
        between(a.left(), b.left(), visit);
        between(a.left(), b.right(), visit);
        between(a.right(), b.left(), visit);
        between(a.right(), b.right(), visit);
    }

    template <typename Visit>
    void one_with(std::uint32_t box, std::size_t from, std::size_t to, Visit& visit) const {
        for (std::size_t j = from; j < to; ++j) {
            if (meet(boxes_[box], boxes_[order_[j]])) {
                visit(box, order_[j]);
            }
        }
    }

    std::span<const Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::size_t first_leaf_ = 1;
    std::vector<Box> bounds_;  ///< By number of node.
};

/// Boxes that meet, touching ones too, are in one set; so are those that others join. Throws base::Stopped.
[[nodiscard]] DisjointSets meeting_sets(const BoxTree& tree, const std::stop_token& stop);

/// That of each triangle.
[[nodiscard]] std::vector<Box> triangle_boxes(std::span<const glm::dvec3> points,
                                              std::span<const glm::uvec3> triangles);

}  // namespace csg::reference
