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
    bool operator==(const Plane&) const = default;
};

/// `a`, `b`, `c` counter-clockwise seen from outside, where the normal points to. For a triangle without area, a plane
/// through its longest edge; it is never drawn with an area, so any such plane does.
[[nodiscard]] Plane plane_through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

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

    /// `a`, `b`, `c` counter-clockwise seen from outside.
    PlaneRef add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        return add(plane_through(a, b, c), a, b, c);
    }
    /// `plane`: that of the triangle, where it is better known than by its corners.
    PlaneRef add(const Plane& plane, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

    [[nodiscard]] const std::vector<Plane>& planes() const { return planes_; }
    [[nodiscard]] double tolerance() const { return tolerance_; }

    /// For whoever changes scenes (plane_keeper.h). The table may have holes: entries that no triangle finds.
    /// Entries that the triangle, with that plane, can share; some twice.
    void find_all(const Plane& plane, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                  std::vector<std::uint32_t>& found) const;
    /// Entries, some of them twice, among which are all that a triangle can share that can also share one with that
    /// plane.
    void find_near(const Plane& plane, std::vector<std::uint32_t>& found) const;
    /// Can a triangle with its plane `own` share an entry with that plane?
    [[nodiscard]] bool shares(const Plane& entry, const Plane& own, const glm::dvec3& a, const glm::dvec3& b,
                              const glm::dvec3& c) const;
    void make_hole(std::uint32_t entry);
    /// Fills a hole, or adds an entry at the end.
    void fill_hole(std::uint32_t entry, const Plane& plane);
    /// The last entry, a hole, goes.
    void drop_last();
    /// Moves all entries: `from[i]` becomes entry i.
    void rearrange(const std::vector<std::uint32_t>& from);

  private:
    /// A place of the hash: what triangles look for and where entries are.
    struct Cell {
        std::int64_t x, y, z, d;
        [[nodiscard]] std::uint64_t hash() const;
    };
    [[nodiscard]] Cell cell(const Plane& plane) const;
    [[nodiscard]] double length() const;  ///< The largest coordinate that the tolerance stands for.
    [[nodiscard]] bool close(const Plane& known, const Plane& own, const glm::dvec3& a, const glm::dvec3& b,
                             const glm::dvec3& c) const;
    /// Calls visit(entry) for entries in the cells that a triangle with that plane looks at.
    template <typename Visit>
    void for_each_in_cells(const Plane& plane, const Visit& visit) const;
    template <typename Visit>
    void for_each_in_cell(std::uint64_t hash, const Visit& visit) const;
    void link(std::uint32_t entry);
    void rehash(std::size_t buckets);

    double tolerance_;
    std::vector<Plane> planes_;
    std::vector<std::uint64_t> hashes_;   ///< Of the entries' cells.
    std::vector<std::uint32_t> next_;     ///< Chains of entries in one bucket; a hole's is itself.
    std::vector<std::uint32_t> buckets_;  ///< Heads of the chains, by the hash of the cell.
};

/// The distance below which faces are one event: a small multiple of the rounding of coordinates as large as the
/// scene's largest (`largest_coordinate`, world units), and far below what a picture can show.
[[nodiscard]] double coincidence_tolerance(double largest_coordinate);

}  // namespace csg::solid
