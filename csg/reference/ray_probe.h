// How often leaves wind around a point, by a ray from there.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "csg/reference/box_pairs.h"
#include "csg/reference/leaf_group.h"
#include "csg/reference/winding.h"

namespace csg::reference {

/// In double precision: rays that pass an edge closely, or begin at a face, are refused. Trees over the boxes of the
/// leaves, and of the triangles of leaves that a ray came near to, leave most out. Not for several threads at a time.
class RayProbe {
  public:
    /// Keeps the reference. `tolerance`: what points may be off (world units).
    RayProbe(const LeafGroup& group, double tolerance);
    ~RayProbe();
    RayProbe(const RayProbe&) = delete;
    RayProbe& operator=(const RayProbe&) = delete;

    /// How often the leaves wind around the points just beyond `origin` in `direction`, faces on plane `without` (of
    /// the group) not counted (the origin is on it). Sorted by leaf; nothing where the ray is too near to an edge, or
    /// its origin to another face, to tell.
    [[nodiscard]] std::optional<Covers> windings(const glm::dvec3& origin, const glm::dvec3& direction,
                                                 std::uint32_t without) const;

  private:
    struct Triangles;
    [[nodiscard]] const Triangles& triangles(LeafId leaf) const;

    const LeafGroup& group_;
    double tolerance_;
    std::vector<Box> boxes_;  ///< Of the leaves.
    BoxTree tree_;
    mutable std::vector<std::unique_ptr<const Triangles>> triangles_;  ///< By leaf, once needed.
};

}  // namespace csg::reference
