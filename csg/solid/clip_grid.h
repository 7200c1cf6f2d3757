// Between outlines in double precision and Clipper's whole numbers.
#pragma once

#include <polyclipping/clipper.hpp>
#include <unordered_map>

#include "csg/solid/outline.h"

namespace csg::solid {

/// Measure all that takes part first, then convert. Remembers which point each grid point came from, to give it back
/// unchanged; points that round to one become one.
class ClipGrid {
  public:
    void measure(std::span<const Loop> loops);
    void measure(double length);
    [[nodiscard]] double scale();  ///< Grid units per unit; a power of two.

    [[nodiscard]] ClipperLib::Path path(const Loop& loop);
    [[nodiscard]] ClipperLib::Paths paths(std::span<const Loop> loops);
    [[nodiscard]] Outline read(const ClipperLib::Paths& paths);

    [[nodiscard]] static ClipperLib::Paths unite(const ClipperLib::Paths& paths, ClipperLib::PolyFillType rule);
    /// Of regions in the form of Outline, or such laid over each other.
    [[nodiscard]] static ClipperLib::Paths combine(ClipperLib::ClipType type, const ClipperLib::Paths& a,
                                                   const ClipperLib::Paths& b);

  private:
    struct Hash {
        std::size_t operator()(const std::pair<ClipperLib::cInt, ClipperLib::cInt>& p) const;
    };
    double largest_ = 0;
    double scale_ = 0;
    std::unordered_map<std::pair<ClipperLib::cInt, ClipperLib::cInt>, glm::dvec2, Hash> origin_;
};

}  // namespace csg::solid
