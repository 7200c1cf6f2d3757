// One ray's fragments to the surfaces of the result.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "goldfeather/expression_state.h"

namespace goldfeather {

/// Where a ray meets a leaf.
struct Fragment {
    double depth = 0;  ///< Reversed: the larger is nearer.
    csg::LeafId leaf = 0;
    std::uint32_t plane = 0;
    std::uint32_t slot = 0;  ///< The caller's own.
};

/// A surface of the result, found among sorted fragments.
struct FoundSurface {
    std::uint32_t first = 0, end = 0;  ///< The fragments of its event.
    csg::LeafId leaf = 0;
    bool reversed = false;
    bool leaving = false;
};

/// Walks along rays. Neighbouring pixels mostly meet the same leaves in the same order: what a sequence of leaves
/// comes to is kept until another one follows.
class PixelWalk {
  public:
    /// `counted_from_behind`: for each leaf whether the near plane may cut it, so that a ray may begin inside it.
    PixelWalk(const ExpressionTree& tree, const csg::Scene& scene, std::span<const char> counted_from_behind,
              int max_layers);

    /// `fragments`: all of the ray's, nearest first. The result stands until the next call.
    [[nodiscard]] std::span<const FoundSurface> walk(std::span<const Fragment> fragments);

  private:
    void evaluate(std::span<const Fragment> fragments);
    void event(std::span<const Fragment> fragments, std::uint32_t first, std::uint32_t end);
    void find_leaf(FoundSurface& surface, csg::PartId part);

    const csg::Scene& scene_;
    std::span<const char> counted_from_behind_;
    std::size_t max_layers_;
    ExpressionState state_;
    std::vector<std::uint32_t> key_;  ///< Leaf << 1 | same event as the fragment before.
    std::vector<FoundSurface> found_;
    std::vector<csg::LeafId> switching_;  ///< Of the event, sorted.
    struct TouchedPart {
        csg::PartId part;
        bool before;
    };
    std::vector<TouchedPart> touched_;
};

}  // namespace goldfeather
