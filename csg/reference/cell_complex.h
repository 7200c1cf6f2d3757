// Space cut up by all faces of a scene: the cells of its planes, and the regions between them.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "csg/reference/plane_cells.h"
#include "csg/reference/winding.h"

namespace csg::reference {

/// A cell of a plane with what is on its two sides.
struct ComplexCell {
    std::uint32_t plane = 0;
    Covers covers;  ///< Winding numbers below are those above plus these.
    std::vector<glm::uvec3> triangles;
    std::uint32_t above = 0, below = 0;  ///< Regions: on the side the plane's normal points to, and on the other.
};

/// A cell at an edge between points lo < hi.
struct ComplexSide {
    std::uint32_t lo, hi;
    std::uint32_t cell;
    bool left;  ///< The cell is to the left of lo → hi, seen against its plane's normal.
};

struct CellComplex {
    std::vector<ComplexCell> cells;
    std::vector<ComplexSide> sides;  ///< By edge, and around each edge counter-clockwise seen against lo → hi.
    std::size_t regions = 0;
    /// Of each connected piece a region of it, with the winding numbers there.
    std::vector<std::pair<std::uint32_t, Covers>> pieces;
};

/// What the complex asks of geometry; each method answers in its own arithmetic.
class ComplexSpace {
  public:
    virtual ~ComplexSpace() = default;
    /// Sorts the sides at one edge counter-clockwise seen against lo → hi, beginning with any.
    virtual void sort_around(std::span<ComplexSide> sides, std::span<const ComplexCell> cells) const = 0;
    /// The winding numbers of all leaves just above the cell; nothing where no ray from it tells.
    [[nodiscard]] virtual std::optional<Covers> windings_above(const ComplexCell& cell) const = 0;
};

/// `cells[i]` are those of plane i. Around every edge the cells are sorted by angle, which tells the regions between
/// them. Throws Undecided.
[[nodiscard]] CellComplex make_complex(std::vector<PlaneCells> cells, const ComplexSpace& space,
                                       const std::stop_token& stop = {});

}  // namespace csg::reference
