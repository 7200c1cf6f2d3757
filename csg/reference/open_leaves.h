// Leaves with holes in their surface, of which nobody can say what is inside.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// Those of the leaves (sorted) some edge of which has an odd number of triangles, equal points being one.
[[nodiscard]] std::vector<LeafId> open_leaves(const solid::Geometry& geometry, std::span<const LeafId> leaves);

/// The first of the `open` leaves that is not united with others only, or whose box is not apart from theirs. Where
/// there is none, their triangles are the result's.
[[nodiscard]] std::optional<LeafId> find_combined(const Scene& scene, const solid::Geometry& geometry,
                                                  std::span<const LeafId> leaves, std::span<const LeafId> open);

/// Appends the leaf's triangles as they are.
void append_leaf(Mesh& mesh, const solid::PlacedLeaf& placed, LeafId leaf);

}  // namespace csg::reference
