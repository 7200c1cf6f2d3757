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
    PlaneSpace(const LeafGroup& group, const Content& content)
        : content_(content), points_(content.points), probe_(group, content.points.tolerance()) {}

    void sort_around(std::span<ComplexSide> sides, std::span<const ComplexCell> cells) const override;
    [[nodiscard]] std::optional<Covers> windings_above(const ComplexCell& cell) const override;

  private:
    const Content& content_;
    const PointTable& points_;
    RayProbe probe_;
};

}  // namespace csg::reference
