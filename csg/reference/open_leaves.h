// Leaves with holes in their surface, of which nobody can say what is inside.
#pragma once

#include <span>
#include <vector>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// Those of the leaves (sorted) some edge of which has an odd number of triangles, equal points being one.
[[nodiscard]] std::vector<LeafId> open_leaves(const solid::Geometry& geometry, std::span<const LeafId> leaves);

/// Is the leaf united with others only, and its box apart from theirs? Then its triangles are the result's.
[[nodiscard]] bool stands_apart(const Scene& scene, const solid::Geometry& geometry, std::span<const LeafId> leaves,
                                LeafId leaf);

/// Appends the leaf's triangles as they are.
void append_leaf(Mesh& mesh, const solid::PlacedLeaf& placed, LeafId leaf);

}  // namespace csg::reference
