// Convex pieces by Nef polyhedra (Hachenberger and Kettner 2005).
#pragma once

#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The corners of convex pieces whose union is the closed mesh. Throws std::runtime_error where it is not closed.
[[nodiscard]] std::vector<std::vector<glm::dvec3>> convex_decomposition(const Mesh& mesh);

}  // namespace csg::reference
