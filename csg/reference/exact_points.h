// Points in exact arithmetic, each once. For this library's own files: it includes CGAL.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace csg::reference {

/// Constructions are kept as intervals and as the way to the exact value, which is found where intervals do not decide.
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// Predicates of points whose coordinates are doubles.
using DoubleKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Finds or adds points by their exact value. Not for several threads: exact values are found on demand.
class ExactPoints {
  public:
    using Point = ExactKernel::Point_3;

    /// `size`: about the largest coordinate.
    explicit ExactPoints(double size);

    std::uint32_t add(const Point& point);
    [[nodiscard]] const Point& operator[](std::uint32_t id) const { return points_[id]; }
    /// Within a hair of the point (2⁻⁴⁰ of the size).
    [[nodiscard]] const glm::dvec3& near(std::uint32_t id) const { return near_[id]; }
    /// The point in doubles, each coordinate a neighbour of the exact one.
    [[nodiscard]] glm::dvec3 rounded(std::uint32_t id) const;
    [[nodiscard]] std::size_t size() const { return points_.size(); }

  private:
    [[nodiscard]] std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const;
    void insert(std::uint32_t id);

    double hair_, cell_;
    std::vector<Point> points_;
    std::vector<glm::dvec3> near_;
    std::vector<std::uint32_t> next_;     ///< Chains of points in one bucket.
    std::vector<std::uint32_t> buckets_;  ///< Heads of the chains; a power of two of them.
};

}  // namespace csg::reference
