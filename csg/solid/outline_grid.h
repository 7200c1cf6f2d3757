// Between outlines in double precision and whole numbers.
#pragma once

#include <unordered_map>

#include "csg/solid/outline.h"
#include "csg/solid/region_loops.h"

namespace csg::solid {

/// Measure all that takes part first, then convert. Remembers which point each grid point came from, to give it back
/// unchanged; points that round to one become one.
class OutlineGrid {
  public:
    void measure(std::span<const Loop> loops);
    void measure(double length);
    [[nodiscard]] double scale();  ///< Grid units per unit; a power of two.

    /// Empty where a coordinate is not finite.
    [[nodiscard]] GridLoop loop(const Loop& loop);
    /// Appends the edges of the loops; they count as `other` (grid_point.h) where that is asked for.
    void add(std::span<const Loop> loops, std::vector<GridEdge>& edges, bool other = false);
    /// Where the given point came from, or as it is.
    [[nodiscard]] glm::dvec2 point(const GridPoint& p);
    /// Keeps the rule of Outline in double precision, too: where given points would break it, which lie up to half a
    /// unit beside those of the grid, they are moved there.
    [[nodiscard]] Outline read(const std::vector<GridLoop>& loops);

  private:
    struct Hash {
        std::size_t operator()(const GridPoint& p) const;
    };
    double largest_ = 0;
    double scale_ = 0;
    std::unordered_map<GridPoint, glm::dvec2, Hash> origin_;
};

}  // namespace csg::solid
