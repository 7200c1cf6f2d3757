// What the complex of cells asks of geometry, answered exactly. For this library's own files: it includes CGAL.
#pragma once

#include <span>
#include <vector>

#include "csg/reference/box_pairs.h"
#include "csg/reference/cell_complex.h"
#include "csg/reference/exact_segments.h"

namespace csg::reference {

class ExactSpace final : public ComplexSpace {
  public:
    /// Keeps the references.
    ExactSpace(const ExactFaces& faces, const ExactPoints& points);

    void sort_around(std::span<ComplexSide> sides, std::span<const ComplexCell> cells) const override;
    [[nodiscard]] std::optional<Covers> windings_above(const ComplexCell& cell) const override;

  private:
    /// A half-plane at an edge: of this plane, on this side of the edge.
    struct Half {
        std::uint32_t plane;
        bool left;
        ComplexSide side;
    };
    /// 1 where `b` is less than half a turn counter-clockwise from `a`, −1 where it is clockwise from it, else 0.
    /// `along`: an axis and whether the edge's direction grows along it.
    [[nodiscard]] int turn(const Half& a, const Half& b, int axis, int along) const;
    [[nodiscard]] const ExactKernel::Vector_3& normal(std::uint32_t plane) const;

    const ExactFaces& faces_;
    const ExactPoints& points_;
    mutable std::vector<ExactKernel::Vector_3> normals_;  ///< By plane, found when first asked for.
    mutable std::vector<char> has_normal_;
    std::vector<Box> boxes_;  ///< Of the faces.
    BoxTree tree_;
};

}  // namespace csg::reference
