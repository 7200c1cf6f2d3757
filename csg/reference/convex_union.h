// The union of many convex polyhedra.
#pragma once

#include <span>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The union of closed convex meshes, as `combine` has it (mesh_boolean.h); all sources are 0. Faces that lie inside
/// another of the polyhedra are left out before planes are cut up, which with Minkowski sums are nearly all; and which
/// cells are on the surface is asked of the polyhedra themselves, by their planes. Where that gives no closed surface
/// (geometry within the tolerance of being degenerate), `combine` is asked. Throws as it does.
[[nodiscard]] Mesh union_of_convex(std::span<const Mesh> meshes, const std::stop_token& stop = {});

}  // namespace csg::reference
