// The boolean expressions of a scene's parts, kept up to date while leaves are entered and left one by one.
//
// Every node counts the children that speak for it, so that entering or leaving a leaf costs a step upwards only as
// long as nodes change: no normalization, and leaves that a ray does not meet cost nothing. The counters do what the
// linear form of Hable and Rossignac's Blister (2005) does with one bit a leaf, without its rescan of the expression.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace goldfeather {

/// What does not change along a ray: shared by all threads.
class ExpressionTree {
  public:
    explicit ExpressionTree(const csg::Scene& scene);

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    struct Node {
        std::uint32_t parent = kNone;
        std::int32_t need = 1;    ///< The node is true where its count is at least that.
        std::int32_t vote = 1;    ///< What it adds to its parent's count when it is true: -1 for what is subtracted.
        bool complement = false;  ///< Below an odd number of subtractions: it must be false for the part to be true.
        csg::PartId part = 0;
    };

    [[nodiscard]] const Node& node(std::uint32_t i) const { return nodes_[i]; }
    [[nodiscard]] std::uint32_t node_of(csg::LeafId leaf) const { return leaf_nodes_[leaf]; }
    /// Counts where no leaf is entered.
    [[nodiscard]] const std::vector<std::int32_t>& counts_outside() const { return counts_; }
    [[nodiscard]] std::size_t part_count() const { return part_count_; }

  private:
    std::vector<Node> nodes_;
    std::vector<std::int32_t> counts_;
    std::vector<std::uint32_t> leaf_nodes_;
    std::size_t part_count_ = 0;
};

/// Where one ray stands. It begins outside of everything.
class ExpressionState {
  public:
    explicit ExpressionState(const ExpressionTree& tree)
        : tree_(tree),
          counts_(tree.counts_outside()),
          parts_(tree.part_count(), 0),
          waiting_(tree.counts_outside().size(), 0) {}

    /// Enters the leaf, or leaves it. Gives true where the value of its part has changed.
    bool toggle(csg::LeafId leaf) {
        std::uint32_t node = tree_.node_of(leaf);
        counts_[node] ^= 1;
        bool value = counts_[node] != 0;
        for (;;) {
            const ExpressionTree::Node& n = tree_.node(node);
            if (n.parent == ExpressionTree::kNone) {
                parts_[n.part] = value ? 1 : 0;
                return true;
            }
            const std::int32_t need = tree_.node(n.parent).need;
            std::int32_t& count = counts_[n.parent];
            const bool before = count >= need;
            count += value ? n.vote : -n.vote;
            value = count >= need;
            if (before == value) {
                return false;
            }
            node = n.parent;
        }
    }

    /// The same for many at once; a leaf that is named twice is entered and left. Every node on the way is looked at
    /// once, while one by one each leaf may turn all nodes above it, down a long chain. Adds the parts that have
    /// changed.
    void toggle(std::span<const csg::LeafId> leaves, std::vector<csg::PartId>& changed);

    [[nodiscard]] bool inside_leaf(csg::LeafId leaf) const { return counts_[tree_.node_of(leaf)] != 0; }
    [[nodiscard]] bool inside_part(csg::PartId part) const { return parts_[part] != 0; }

    /// Is the leaf a literal of a product that is true here? (docs/ENGINES.md, "Whose surface it is".)
    [[nodiscard]] bool responsible(csg::LeafId leaf) const {
        for (std::uint32_t node = tree_.node_of(leaf); node != ExpressionTree::kNone; node = tree_.node(node).parent) {
            const ExpressionTree::Node& n = tree_.node(node);
            if ((counts_[node] >= n.need) == n.complement) {
                return false;
            }
        }
        return true;
    }

  private:
    const ExpressionTree& tree_;
    std::vector<std::int32_t> counts_;
    std::vector<char> parts_;

    /// A node whose count has changed, and whether it was true before.
    struct Turned {
        std::uint32_t node;
        bool before;
        bool operator<(const Turned& other) const { return node > other.node; }  ///< The first one on top of the heap.
    };
    void wait(std::uint32_t node);

    std::vector<Turned> heap_;
    std::vector<char> waiting_;  ///< By node: whether it is in the heap.
};

}  // namespace goldfeather
