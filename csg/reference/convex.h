// Convex polyhedra and polygons, and their Minkowski sums.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// A convex polyhedron, or a convex polygon in space. Which point is the farthest in a direction is found by walking
/// along edges uphill: what is highest among its neighbors is highest of all.
class Convex {
  public:
    /// The hull of the points; without points where they lie in one plane.
    [[nodiscard]] static Convex hull_of(std::span<const glm::dvec3> points, const std::stop_token& stop = {});
    /// The corners of a convex polygon in turn.
    [[nodiscard]] static Convex polygon(std::vector<glm::dvec3> corners);

    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return mesh_.points; }
    /// None where it is a polygon.
    [[nodiscard]] const std::vector<glm::uvec3>& triangles() const { return mesh_.triangles; }
    [[nodiscard]] bool empty() const { return mesh_.points.empty(); }
    /// Not of unit length; both sides where it is a polygon.
    [[nodiscard]] std::vector<glm::dvec3> normals() const;
    /// The index of a point that is farthest in the direction, up to rounding; the walk begins at point `from`.
    [[nodiscard]] std::uint32_t farthest(const glm::dvec3& direction, std::uint32_t from) const;
    [[nodiscard]] glm::dvec3 middle() const;  ///< The mean of the points.

  private:
    void connect();

    Mesh mesh_;
    std::vector<std::uint32_t> first_, neighbors_;  ///< By point: its neighbors from first_[i] to first_[i + 1].
};

/// The hull of all sums of a point of one and a point of the other; empty where it is flat. Where these are many, most
/// are never formed: from the points that are extreme along the normals of either, the hull grows by what is farthest
/// along the normals of its own faces, until nothing lies beyond one of them by more than 2^-40 of the largest
/// coordinate. So the work is that of hulls as large as the result's. Throws
/// base::Stopped where `stop` asked for it.
[[nodiscard]] Mesh sum_of_convex(const Convex& a, const Convex& b, const std::stop_token& stop = {});

}  // namespace csg::reference
