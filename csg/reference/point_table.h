// One table of all points of an arrangement: whether two points are one is decided here, once.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "csg/reference/point_grid.h"

namespace csg::reference {

/// Finds or adds points. A point within `tolerance` of a known one is that point. The tolerance lies far above the
/// rounding of an intersection and far below the distance of points that are meant to be two.
class PointTable {
  public:
    explicit PointTable(double tolerance) : tolerance_(tolerance), grid_(tolerance) {}

    std::uint32_t add(const glm::dvec3& point) {
        const std::uint32_t known = grid_.find(point, [&](std::uint32_t id) {
            const glm::dvec3 way = (*this)[id] - point;
            return glm::dot(way, way) <= tolerance_ * tolerance_;
        });
        return known != PointGrid::kNone ? known : grid_.add(point);
    }

    [[nodiscard]] const glm::dvec3& operator[](std::uint32_t id) const { return grid_.points()[id]; }
    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return grid_.points(); }
    [[nodiscard]] double tolerance() const { return tolerance_; }

  private:
    double tolerance_;
    PointGrid grid_;
};

}  // namespace csg::reference
