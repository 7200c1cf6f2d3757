// Operations in exact arithmetic on Nef polyhedra (Hachenberger and Kettner 2005): slow, and never at a loss.
#pragma once

#include <span>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// The union of the solid parts, operation by operation; coincidence is that of the coordinates, to the last bit. The
/// sources of the mesh's triangles are found by their planes; a leaf that is not closed throws std::runtime_error.
[[nodiscard]] Mesh nef_boolean(const Scene& scene, const solid::Geometry& geometry);

/// The Minkowski sum of closed meshes, one after the other: convex ones as the hull of their points' sums, others by
/// decomposition into convex pieces. All sources are 0. Throws std::runtime_error where a mesh is not closed.
[[nodiscard]] Mesh minkowski_sum(std::span<const Mesh> operands);

}  // namespace csg::reference
