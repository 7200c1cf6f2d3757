// The boolean expressions of a scene's parts, kept up to date while leaves are entered and left one by one.
//
// Every gate counts its inputs, so that entering or leaving a leaf costs a step upwards only as long as gates turn: no
// normalization to products, and leaves that a ray does not meet cost nothing. The counters do what the linear form of
// Hable and Rossignac's Blister (2005) does with one bit a leaf, without its rescan of the expression.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace goldfeather {

/// What does not change along a ray: shared by all threads. Complements are moved down to the leaves (negation normal
/// form), and gates of one kind within each other are one: what is left are ANDs and ORs in turn over literals, and
/// when a literal turns, all gates above it that turn, turn the same way.
class ExpressionTree {
  public:
    explicit ExpressionTree(const csg::Scene& scene);

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// True where its margin is not negative: an AND lacks so many inputs, an OR has one more than that.
    struct Gate {
        std::uint32_t parent = kNone;  ///< Its index is less than the gate's own.
        csg::PartId part = 0;
    };
    /// A leaf or its complement, and the gate that it is an input of.
    struct Literal {
        std::uint32_t gate = kNone;
        bool complement = false;  ///< Below an odd number of subtractions: it must be outside for the part to be true.
    };

    [[nodiscard]] const Gate& gate(std::uint32_t i) const { return gates_[i]; }
    [[nodiscard]] const Literal& literal(csg::LeafId leaf) const { return literals_[leaf]; }
    /// By gate, where no leaf is entered.
    [[nodiscard]] const std::vector<std::int32_t>& margins_outside() const { return margins_; }
    [[nodiscard]] std::size_t leaf_count() const { return literals_.size(); }
    [[nodiscard]] std::size_t part_count() const { return part_count_; }

  private:
    std::vector<Gate> gates_;
    std::vector<std::int32_t> margins_;
    std::vector<Literal> literals_;  ///< By leaf.
    std::size_t part_count_ = 0;
};

/// Where one ray stands. It begins outside of everything.
class ExpressionState {
  public:
    explicit ExpressionState(const ExpressionTree& tree)
        : tree_(tree),
          margins_(tree.margins_outside()),
          inside_(tree.leaf_count(), 0),
          parts_(tree.part_count(), 0),
          waiting_(tree.margins_outside().size(), 0) {}

    /// Enters the leaf, or leaves it. Gives true where the value of its part has changed.
    bool toggle(csg::LeafId leaf) {
        const ExpressionTree::Literal& literal = tree_.literal(leaf);
        const std::int32_t step = turn(leaf, literal);
        const std::int32_t turning = step > 0 ? 0 : -1;  // The margin of a gate that has just turned.
        std::uint32_t gate = literal.gate;
        while ((margins_[gate] += step) == turning) {
            const ExpressionTree::Gate& g = tree_.gate(gate);
            if (g.parent == ExpressionTree::kNone) {
                parts_[g.part] = step > 0 ? 1 : 0;
                return true;
            }
            gate = g.parent;
        }
        return false;
    }

    /// The same for many at once; a leaf that is named twice is entered and left. Every gate on the way is looked at
    /// once, while one by one each leaf may turn all gates above it, down a long chain. Adds the parts that have
    /// changed.
    void toggle(std::span<const csg::LeafId> leaves, std::vector<csg::PartId>& changed);

    [[nodiscard]] bool inside_leaf(csg::LeafId leaf) const { return inside_[leaf] != 0; }
    [[nodiscard]] bool inside_part(csg::PartId part) const { return parts_[part] != 0; }
    /// How many leaves hold the point.
    [[nodiscard]] std::int32_t entered() const { return entered_; }

    /// Is the leaf a literal of a product that is true here? (docs/ENGINES.md, "Whose surface it is".)
    [[nodiscard]] bool responsible(csg::LeafId leaf) const {
        const ExpressionTree::Literal& literal = tree_.literal(leaf);
        bool value = inside_leaf(leaf) != literal.complement;
        for (std::uint32_t gate = literal.gate; value && gate != ExpressionTree::kNone;
             gate = tree_.gate(gate).parent) {
            value = margins_[gate] >= 0;
        }
        return value;
    }

  private:
    /// Enters or leaves the leaf alone. Gives 1 where its literal is true then, otherwise -1.
    std::int32_t turn(csg::LeafId leaf, const ExpressionTree::Literal& literal) {
        const bool inside = inside_[leaf] == 0;
        inside_[leaf] = inside ? 1 : 0;
        entered_ += inside ? 1 : -1;
        return inside != literal.complement ? 1 : -1;
    }

    const ExpressionTree& tree_;
    std::vector<std::int32_t> margins_;
    std::vector<char> inside_;
    std::vector<char> parts_;
    std::int32_t entered_ = 0;

    /// A gate whose margin has changed, and whether it was true before.
    struct Turned {
        std::uint32_t gate;
        bool before;
        bool operator<(const Turned& other) const { return gate < other.gate; }  ///< The last one on top of the heap.
    };
    void wait(std::uint32_t gate);

    std::vector<Turned> heap_;
    std::vector<char> waiting_;  ///< By gate: whether it is in the heap.
};

}  // namespace goldfeather
