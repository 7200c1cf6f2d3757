// Operations in exact arithmetic on Nef polyhedra (Hachenberger and Kettner 2005): slow, and never at a loss.
#pragma once

#include <vector>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// The union of the solid parts, operation by operation; coincidence is that of the coordinates, to the last bit. The
/// sources of the mesh's triangles are found by their planes; a leaf that is not closed throws std::runtime_error.
[[nodiscard]] Mesh nef_boolean(const Scene& scene, const solid::Geometry& geometry);

/// The corners of convex pieces whose union is the closed mesh. Throws std::runtime_error where it is not closed.
[[nodiscard]] std::vector<std::vector<glm::dvec3>> convex_decomposition(const Mesh& mesh);

}  // namespace csg::reference
