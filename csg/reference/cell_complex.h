// Space cut up by all faces of a scene: the cells of its planes, and the regions between them.
#pragma once

#include <span>
#include <vector>

#include "csg/reference/plane_cells.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// A cell of a plane with what is on its two sides.
struct ComplexCell {
    std::uint32_t plane = 0;
    std::vector<LeafId> leaves;
    std::vector<glm::uvec3> triangles;
    std::uint32_t above = 0, below = 0;  ///< Regions: on the side the plane's normal points to, and on the other.
};

struct CellComplex {
    std::vector<ComplexCell> cells;
    std::size_t regions = 0;
    std::size_t words = 0;              ///< Of 64 leaves each.
    std::vector<std::uint64_t> inside;  ///< By region, `words` each: bit i is set where the i-th leaf holds the region.

    [[nodiscard]] std::span<const std::uint64_t> holders(std::uint32_t region) const {
        return std::span(inside).subspan(region * words, words);
    }
};

/// `cells[i]` are those of plane i; bit i of `holders` stands for `leaves[i]` (sorted). Around every edge the cells are
/// sorted by angle, which tells the regions between them; which leaves hold a region follows from a neighbour, and for
/// each connected piece from one ray. Throws Undecided.
[[nodiscard]] CellComplex make_complex(const solid::Geometry& geometry, std::span<const LeafId> leaves,
                                       const PointTable& points, std::vector<PlaneCells> cells);

}  // namespace csg::reference
