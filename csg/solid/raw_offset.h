// The loop that a line or a loop becomes when each of its edges moves to its right, before it is cleaned.
#pragma once

#include "csg/solid/widen.h"

namespace csg::solid {

/// Goes along the edges that have moved, around joins where they part, and by way of the corner where they do not. So
/// it is, edge for edge, the sum of the given loop and the outlines of what is swept: a quadrilateral for each edge,
/// a polygon for each join; all counter-clockwise, or, where the distance is negative, all clockwise. It winds around
/// a point as often as the region and all of these together do, and what is inside is where that is above 0: what the
/// region or any of these holds, or what the region holds and none of these.
class RawOffset {
  public:
    /// Lengths below `unit` do not count.
    RawOffset(const Widening& how, double unit);

    /// Loops do not repeat their first corner. Empty where nothing is swept.
    [[nodiscard]] Loop around(const Loop& line);

    /// Around what is swept when the edges of an open line move, with the joins between them, and a quarter as far to
    /// the other side without joins: counter-clockwise, or clockwise where the distance is negative.
    [[nodiscard]] Loop beside(const Loop& line);

  private:
    struct Bend;

    void add(const glm::dvec2& corner, const glm::dvec2& way) { loop_.push_back(corner + how_.distance * way); }
    void add_corner(const glm::dvec2& corner, const Bend& bend);
    void add_arc(const glm::dvec2& corner, const Bend& bend);
    void add_square(const glm::dvec2& corner, const Bend& bend);
    void add_end(const glm::dvec2& corner, const glm::dvec2& normal);
    void add_dot(const glm::dvec2& center);

    Widening how_;
    double unit_, steps_, least_miter_;
    Loop loop_;
};

}  // namespace csg::solid
