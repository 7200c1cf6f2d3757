// One table of all points of an arrangement: whether two points are one is decided here, once.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace csg::reference {

/// Finds or adds points. A point within `tolerance` of a known one is that point. The tolerance lies far above the
/// rounding of an intersection and far below the distance of points that are meant to be two.
class PointTable {
  public:
    explicit PointTable(double tolerance);

    std::uint32_t add(const glm::dvec3& point);

    [[nodiscard]] const glm::dvec3& operator[](std::uint32_t id) const { return points_[id]; }
    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return points_; }
    [[nodiscard]] double tolerance() const { return tolerance_; }

  private:
    [[nodiscard]] std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const;
    void insert(std::uint32_t id);

    double tolerance_;
    double cell_;
    std::vector<glm::dvec3> points_;
    std::vector<std::uint32_t> next_;     ///< Chains of points in one bucket.
    std::vector<std::uint32_t> buckets_;  ///< Heads of the chains; a power of two of them.
};

}  // namespace csg::reference
