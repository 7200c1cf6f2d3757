// Regions of the plane by their outlines, and what can be done with them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "csg/tree/box.h"
#include "csg/tree/leaf_shape.h"
#include "csg/tree/mesh_operation.h"

namespace csg::solid {

/// Something cannot be computed, for the reason given.
class GeometryError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Coordinates beyond what can be worked with.
class OutlineError : public GeometryError {
  public:
    using GeometryError::GeometryError;
};

using Loop = std::vector<glm::dvec2>;

/// A region, as the boundary of what is inside. Everything below and every import gives it by one rule:
/// - every edge has the region on its left: loops go counter-clockwise around what is inside, clockwise around holes;
/// - no edge is used twice, and edges meet in their ends only: where loops touch, they have a corner there;
/// - each loop is simple: it touches itself nowhere. Where the boundary meets itself in a point, what is inside is
///   taken apart there (loops turn as far to the left as they can); what still comes back to the point, as around a
///   hole that touches the outside, is a loop of its own.
/// It holds exactly for the doubles that the coordinates are (is_region, indexed_outline.h).
struct Outline {
    std::vector<Loop> loops;

    [[nodiscard]] bool empty() const { return loops.empty(); }
    /// Of all loops together.
    [[nodiscard]] std::size_t corners() const;
    /// Square units; holes count against it.
    [[nodiscard]] double area() const;
};

/// Twice the signed area of a triangle: positive where c lies to the left of the way from a to b.
[[nodiscard]] inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Twice the signed area of a loop: positive where it is counter-clockwise.
[[nodiscard]] double area2(const Loop& loop);

/// Flat, at z = 0; empty where there are no corners.
[[nodiscard]] Box bounds_of(std::span<const Loop> loops);

enum class FillRule : std::uint8_t { EvenOdd, NonZero };

// All of these round coordinates to a grid of 2^-40 of the largest of them while they work, far below what makes faces
// distinct (plane_table.h); vertices that were there before come back with all their bits. OpenSCAD's grid is 2^-16
// units wide. Loops with a coordinate that is not finite are left out. Each throws OutlineError for what is beyond what
// can be worked with (arrangement.h): coordinates, or more than two million crossings.

/// The region that loops of any kind enclose.
[[nodiscard]] Outline clean(std::span<const Loop> loops, FillRule rule);

enum class BooleanKind : std::uint8_t { Union, Difference, Intersection };
/// The first with all others. A difference is the first minus the others; none of any gives nothing.
[[nodiscard]] Outline combine(BooleanKind kind, std::span<const std::shared_ptr<const Outline>> operands);

/// OpenSCAD's offset().
[[nodiscard]] Outline offset(const Outline& outline, const Offset& how);

/// Without holes.
[[nodiscard]] Outline fill(const Outline& outline);

/// The convex hull of all points.
[[nodiscard]] Outline hull(std::span<const glm::dvec2> points);

/// The Minkowski sum of two regions.
[[nodiscard]] Outline minkowski(const Outline& a, const Outline& b);

/// By the upper left of the matrix; a mirrored region is turned around again. One that collapses is empty.
[[nodiscard]] Outline transform(const Outline& outline, const glm::dmat4& matrix);

/// Square, circle or polygon, with OpenSCAD's vertices.
[[nodiscard]] Outline make_outline(const Square& square);
[[nodiscard]] Outline make_outline(const Circle& circle);
[[nodiscard]] Outline make_outline(const Polygon& polygon);

}  // namespace csg::solid
