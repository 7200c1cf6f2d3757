// Outlines on a grid of integers, for algorithms that are exact there.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace csg::reference {

/// A region's loops rounded to a grid of 2^-29 to 2^-30 of the larger side of their box; corners within two cells of an
/// edge are put on it, as rounding may have moved them over it. Loops share points with each
/// other or with themselves at most: none crosses or touches an edge elsewhere, and no edge occurs twice. Points on
/// straight lines are left out, and loops without area. Where loops meet, each follows the same part of the region.
class GridOutline {
  public:
    using Point = glm::i64vec2;  ///< From -2^29 to 2^29 each, so that `turn` is exact.
    using Loop = std::vector<Point>;

    /// Throws std::runtime_error where the loops cross by more than that, or overlap along an edge, or a coordinate is
    /// not finite.
    explicit GridOutline(std::span<const std::vector<glm::dvec2>> loops);

    [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
    /// Where a corner was before it was rounded.
    [[nodiscard]] glm::dvec2 corner(const Point& p) const { return origin_.at({p.x, p.y}); }
    /// A point anywhere, in the outline's units.
    [[nodiscard]] glm::dvec2 place(const glm::dvec2& p) const { return center_ + p / scale_; }
    /// A distance, in the outline's units.
    [[nodiscard]] double length(double cells) const { return cells / scale_; }

  private:
    std::vector<Loop> loops_;
    std::map<std::pair<std::int64_t, std::int64_t>, glm::dvec2> origin_;
    glm::dvec2 center_{0.0};
    double scale_ = 1;  ///< Cells a unit; a power of two, so that short binary fractions are not rounded.
};

/// Twice the signed area of a triangle: positive where c lies to the left of the way from a to b.
[[nodiscard]] inline std::int64_t turn(const GridOutline::Point& a, const GridOutline::Point& b,
                                       const GridOutline::Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace csg::reference
