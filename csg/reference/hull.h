// Convex hulls.
#pragma once

#include <span>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The convex hull of the points; empty where they lie in one plane. All sources are 0. Exact predicates.
[[nodiscard]] Mesh hull(std::span<const glm::dvec3> points);

/// Is the mesh convex, exactly? A closed mesh is expected.
[[nodiscard]] bool convex(const Mesh& mesh);

}  // namespace csg::reference
