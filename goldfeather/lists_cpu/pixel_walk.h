// One ray's fragments to the surfaces of the result.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "goldfeather/lists_cpu/expression_state.h"

namespace goldfeather {

/// Where a ray meets a leaf.
struct Fragment {
    double depth = 0;                 ///< Reversed: the larger is nearer.
    std::uint32_t leaf_and_side = 0;  ///< Leaf << 1 | seen from inside the leaf, where that is wound.
    std::uint32_t plane = 0;
    std::uint32_t slot = 0;  ///< The caller's own.

    [[nodiscard]] csg::LeafId leaf() const { return leaf_and_side >> 1; }
    [[nodiscard]] bool from_behind() const { return (leaf_and_side & 1U) != 0; }
};

/// A surface of the result, found among sorted fragments.
struct FoundSurface {
    std::uint32_t first = 0, end = 0;  ///< The fragments of its event.
    csg::LeafId leaf = 0;
    bool reversed = false;
    bool leaving = false;
};

/// Walks along rays. Most pixels of a neighborhood meet the same few sequences of leaves: what a sequence comes to is
/// remembered, in a place that its hash decides, until another one needs the place.
class PixelWalk {
  public:
    /// `counted_from_behind`: for each leaf whether the near plane may cut it, so that a ray may begin inside it.
    /// `wound`: for each leaf whether its inside is where its winding number is not zero; otherwise it is where the
    /// parity says so, and directions are not looked at. `ranks`: of parts (part_order.h).
    PixelWalk(const ExpressionTree& tree, const csg::Scene& scene, std::span<const std::uint32_t> ranks,
              std::span<const char> counted_from_behind, std::span<const char> wound, int max_layers);

    /// `fragments`: all of the ray's, nearest first. The result stands until the next call.
    [[nodiscard]] std::span<const FoundSurface> walk(std::span<const Fragment> fragments);

  private:
    /// A sequence and what it comes to.
    struct Known {
        /// Leaf and side << 1 | same event as the fragment before.
        std::vector<std::uint32_t> key;
        std::vector<FoundSurface> found;
    };
    static constexpr std::size_t kRemembered = 256;
    static constexpr std::size_t kOneByOne = 16;  ///< So many leaves are entered or left one after the other.
    static constexpr std::size_t kLongest = 256;  ///< Longer sequences share one place: they would fill the memory.

    void evaluate(std::span<const Fragment> fragments, Known& known);
    void enter_from_behind(std::span<const Fragment> fragments);
    void leave_all(std::span<const Fragment> fragments);
    /// Counts a surface of a leaf. Gives true where the leaf is entered or left there.
    bool turns(csg::LeafId leaf, std::int32_t step);
    void single_event(const Fragment& fragment, std::uint32_t at, std::vector<FoundSurface>& found);
    void event(std::span<const Fragment> fragments, std::uint32_t first, std::uint32_t end,
               std::vector<FoundSurface>& found);
    /// Enters or leaves those in switching_; adds to changed_ the parts that are others then.
    void toggle_switching();
    /// Sets leaf and orientation. The state must be that of the result's side of the event.
    void find_leaf(FoundSurface& surface, csg::PartId part);

    const ExpressionTree& tree_;
    const csg::Scene& scene_;
    std::span<const std::uint32_t> ranks_;
    std::span<const char> counted_from_behind_, wound_;
    bool any_wound_;
    std::vector<std::int32_t> winding_;  ///< By leaf: how often the mesh is around the point. Of wound leaves.
    std::size_t max_layers_;
    ExpressionState state_;
    std::vector<std::uint32_t> key_;  ///< Of the ray at hand.
    std::vector<Known> known_;
    std::vector<csg::LeafId> switching_;  ///< Of the event, sorted by part, then by leaf.
    std::vector<csg::PartId> changed_;    ///< By the last toggle_switching.
    std::vector<csg::PartId> left_;       ///< The event's changed parts.
};

}  // namespace goldfeather
