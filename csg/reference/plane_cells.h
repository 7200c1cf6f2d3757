// The cells of one plane: maximal areas that no segment crosses, with how often the faces of leaves cover them.
#pragma once

#include <span>
#include <utility>

#include "csg/reference/segments.h"
#include "csg/reference/winding.h"

namespace csg::reference {

struct PlaneCells {
    struct Cell {
        /// How often each leaf's faces cover the cell: those that face as the plane does minus those that face the
        /// other way, or of a leaf whose inside is where it is met an odd number of times, whether their number is odd.
        Covers covers;
        std::vector<glm::uvec3> triangles;  ///< Points of the table, counter-clockwise about the plane's normal.
    };
    struct Side {
        std::uint32_t lo, hi;  ///< An edge of the cell, between points lo < hi.
        std::uint32_t cell;
        bool left;  ///< The cell is to the left of lo → hi, seen against the plane's normal.
    };
    std::vector<Cell> cells;
    std::vector<Side> sides;
};

/// Triangulates (constrained Delaunay) the plane's segments after they have been split. Cells that no leaf covers are
/// left out. Throws Undecided.
[[nodiscard]] PlaneCells make_cells(const Content& content, const PlaneContent& plane, const InsideRule& rule);

/// Triangles (constrained Delaunay) that fill what lies to the left of `border`, edges between `points` in a plane,
/// counter-clockwise about its normal. Throws Undecided where edges cross or touch but in their ends, or do not close.
[[nodiscard]] std::vector<glm::uvec3> fill_area(std::span<const std::pair<std::uint32_t, std::uint32_t>> border,
                                                std::span<const glm::dvec3> points, const glm::dvec3& normal);

}  // namespace csg::reference
