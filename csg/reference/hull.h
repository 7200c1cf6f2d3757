// Convex hulls.
#pragma once

#include <span>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The convex hull of the points; empty where they lie in one plane. All sources are 0. Exact predicates.
/// Throws base::Stopped where `stop` asked for it.
[[nodiscard]] Mesh hull(std::span<const glm::dvec3> points, const std::stop_token& stop = {});

/// Is the mesh convex, exactly? A closed mesh is expected.
[[nodiscard]] bool convex(const Mesh& mesh);

}  // namespace csg::reference
