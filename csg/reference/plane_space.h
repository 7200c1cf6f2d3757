// What the complex of cells asks of geometry, answered in double precision.
#pragma once

#include "csg/reference/cell_complex.h"
#include "csg/reference/point_table.h"
#include "csg/reference/ray_probe.h"

namespace csg::reference {

/// Angles come from the canonical planes. Both answers throw Undecided where doubles cannot tell.
class PlaneSpace final : public ComplexSpace {
  public:
    /// Keeps the references.
    PlaneSpace(const solid::Geometry& geometry, std::span<const LeafId> leaves, const PointTable& points)
        : geometry_(geometry), points_(points), probe_(geometry, leaves, points.tolerance()) {}

    void sort_around(std::span<ComplexSide> sides, std::span<const ComplexCell> cells) const override;
    [[nodiscard]] Covers windings_above(const ComplexCell& cell) const override;

  private:
    const solid::Geometry& geometry_;
    const PointTable& points_;
    RayProbe probe_;
};

}  // namespace csg::reference
