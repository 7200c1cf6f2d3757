// The boolean expressions of a scene in the linear form of Hable and Rossignac's Blister (2005): each leaf has one
// pointer for "inside" and one for "outside", which lead forward to the next leaf that matters or to a result.
//
// A leaf that a ray does not meet is outside, and its pointer never changes. The outside pointers therefore form a
// forest, whose trees end in a result, and an interval of an Euler tour tells at once whether one leaf is on the chain
// of another. So the value of an expression takes a step for each leaf that holds the point, and none for the others:
// from a leaf the next that matters is the first on its chain that holds the point.
//
// Expressions are brought to negation normal form first (an n-ary AND or OR of leaves and complements of leaves), which
// changes neither the number of leaves nor their order.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace goldfeather {

/// Immutable. Rows have the layout of goldfeather/lists/blist.glsl, which evaluates them the same way.
class Blist {
  public:
    /// Exits of a chain. Leaves are smaller.
    static constexpr std::uint32_t kTrue = 0xfffffffeU, kFalse = 0xffffffffU;
    static constexpr std::uint32_t kNone = 0xffffffffU;  ///< No group.

    struct Leaf {
        std::uint32_t inside = kFalse;  ///< The next leaf, or a result, where the leaf holds the point.
        /// Places in the tour of the outside pointers: `a` is on the chain of `b` where
        /// a.first <= b.first && b.first <= a.last. A leaf that no result depends on is on no chain.
        std::uint32_t first = kNone, last = 0;
        std::uint32_t chain_end = kFalse;  ///< The result where no leaf of the chain holds the point.
        std::uint32_t group = kNone;       ///< The innermost AND that the leaf is in.
        std::uint32_t complement = 0;      ///< 1: the leaf must not hold the point.
        std::uint32_t rank = 0;            ///< Of its part, in the order of parts.
        std::uint32_t flags = 0;           ///< Not used here: blist_buffer.h.
    };

    /// An AND that is not directly in another AND. It is true where the value from `start` leaves the leaves up to
    /// `last` by the exit `when_true`, and false where it leaves by `when_false`.
    struct Group {
        std::uint32_t start = 0, last = 0;
        std::uint32_t when_true = kTrue, when_false = kFalse;
        std::uint32_t parent = kNone;  ///< The next AND outwards. This one is in its operand from …
        std::uint32_t operand = 0;     ///< … the leaf where that begins, …
        std::uint32_t next = kTrue;    ///< … which leads there where it is true.
        std::uint32_t unused = 0;
    };

    /// `order`: of parts (part_order.h).
    Blist(const csg::Scene& scene, std::vector<csg::PartId> order);

    [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }  ///< By LeafId.
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
    /// By rank: the first leaf of the part's list, or the result of an expression that is constant.
    [[nodiscard]] const std::vector<std::uint32_t>& starts() const { return starts_; }
    /// Part ids by rank.
    [[nodiscard]] const std::vector<csg::PartId>& parts() const { return parts_; }

    /// The value of a part's expression where exactly the leaves in `inside` hold the point.
    [[nodiscard]] bool value(std::uint32_t rank, std::span<const csg::LeafId> inside) const;
    /// Is the leaf a literal of a product that is true there? (docs/ENGINES.md, "Whose surface it is".)
    [[nodiscard]] bool responsible(csg::LeafId leaf, std::span<const csg::LeafId> inside) const;

  private:
    class Builder;
    [[nodiscard]] bool value(const Group& of, std::span<const csg::LeafId> inside) const;

    std::vector<Leaf> leaves_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> starts_;
    std::vector<csg::PartId> parts_;
};

}  // namespace goldfeather
