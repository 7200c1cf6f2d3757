// One table of all planes of a scene: coincidence of faces is decided here, once (DESIGN, section 3, rule 2).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace csg::solid {

/// The points p with dot(normal, p) = offset; `normal` has unit length. World coordinates.
struct Plane {
    glm::dvec3 normal{0, 0, 1};
    double offset = 0;
};

/// A plane of the table with a side: `flipped` where the triangle's outward normal is opposite to the table's.
struct PlaneRef {
    std::uint32_t index = 0;
    bool flipped = false;
};

/// Finds or adds planes. Two triangles share an entry where all vertices of the later one lie within `tolerance` of
/// the plane of the earlier one and the normals are parallel or opposite to the same accuracy. Order decides which
/// numbers an entry gets, so the same scene gives the same table in every run.
class PlaneTable {
  public:
    /// `tolerance` is a length in world units; see `coincidence_tolerance`.
    explicit PlaneTable(double tolerance = 0) : tolerance_(tolerance) {}

    /// `a`, `b`, `c` counter-clockwise seen from outside. A triangle without area gets the plane through its points
    /// nearest to its longest edge; it is never drawn with an area, so any such plane does.
    PlaneRef add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

    [[nodiscard]] const std::vector<Plane>& planes() const { return planes_; }
    [[nodiscard]] double tolerance() const { return tolerance_; }

  private:
    [[nodiscard]] std::uint64_t cell(const glm::dvec3& normal, double offset) const;
    [[nodiscard]] double length() const;  ///< The largest coordinate that the tolerance stands for.
    [[nodiscard]] std::uint32_t find(const Plane& plane, const glm::dvec3& a, const glm::dvec3& b,
                                     const glm::dvec3& c) const;
    void insert(std::uint32_t entry);

    double tolerance_;
    std::vector<Plane> planes_;
    std::vector<std::uint32_t> next_;     ///< Chains of entries in one bucket.
    std::vector<std::uint32_t> buckets_;  ///< Heads of the chains, by the hash of the cell.
};

/// The distance below which faces are one event: a small multiple of the rounding of coordinates as large as the
/// scene's largest (`largest_coordinate`, world units), and far below what a picture can show.
[[nodiscard]] double coincidence_tolerance(double largest_coordinate);

}  // namespace csg::solid
