// Points in exact arithmetic, each once. For this library's own files: it includes CGAL.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "csg/reference/point_grid.h"

namespace csg::reference {

/// Constructions are kept as intervals and as the way to the exact value, which is found where intervals do not decide.
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// Predicates of points whose coordinates are doubles.
using DoubleKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

[[nodiscard]] inline ExactKernel::Point_3 exact(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

/// Finds or adds points by their exact value. Not for several threads: exact values are found on demand.
class ExactPoints {
  public:
    using Point = ExactKernel::Point_3;

    /// `size`: about the largest coordinate.
    explicit ExactPoints(double size);

    std::uint32_t add(const Point& point);
    [[nodiscard]] const Point& operator[](std::uint32_t id) const { return points_[id]; }
    /// Within a hair of the point (2⁻⁴⁰ of the size).
    [[nodiscard]] const glm::dvec3& near(std::uint32_t id) const { return grid_.points()[id]; }
    /// The point in doubles, each coordinate a neighbor of the exact one.
    [[nodiscard]] glm::dvec3 rounded(std::uint32_t id) const;
    [[nodiscard]] std::size_t size() const { return points_.size(); }

  private:
    double hair_;
    PointGrid grid_;  ///< Of what is near the points.
    std::vector<Point> points_;
};

}  // namespace csg::reference
