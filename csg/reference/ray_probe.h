// How often leaves wind around a point, by a ray from there.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "csg/reference/box_pairs.h"
#include "csg/reference/winding.h"
#include "csg/solid/placed.h"

namespace csg::reference {

/// In double precision: rays that pass an edge closely are refused. Trees over the boxes of the leaves, and of the
/// triangles of leaves that a ray came near to, leave most out. Not for several threads at a time.
class RayProbe {
  public:
    /// Keeps the references. `tolerance`: what points may be off (world units).
    RayProbe(const solid::Geometry& geometry, std::span<const LeafId> leaves, double tolerance);
    ~RayProbe();
    RayProbe(const RayProbe&) = delete;
    RayProbe& operator=(const RayProbe&) = delete;

    /// How often the leaves wind around the points just beyond `origin` in `direction`, faces on plane `without` not
    /// counted (the origin is on it). Sorted by leaf; nothing where the ray is too near to an edge to tell.
    [[nodiscard]] std::optional<Covers> windings(const glm::dvec3& origin, const glm::dvec3& direction,
                                                 std::uint32_t without) const;

  private:
    struct Triangles;
    [[nodiscard]] const Triangles& triangles(std::uint32_t index) const;

    const solid::Geometry& geometry_;
    std::span<const LeafId> leaves_;
    double tolerance_;
    std::vector<Box> boxes_;  ///< Of the leaves.
    BoxTree tree_;
    mutable std::vector<std::unique_ptr<const Triangles>> triangles_;  ///< By place in `leaves_`, once needed.
};

}  // namespace csg::reference
