// Meshes taken apart and put together by their edges.
#pragma once

#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The pieces of a mesh: across an edge of two triangles a piece goes on, across an edge where more meet it does not,
/// nor across a corner. So solids that only touch are apart. Sources are kept.
[[nodiscard]] std::vector<Mesh> components_of(const Mesh& mesh);

/// The same surface with one point for each place and without triangles that have a corner twice.
[[nodiscard]] Mesh welded(const Mesh& mesh);

/// Does each directed edge occur as often as its opposite? Of a welded mesh.
[[nodiscard]] bool balanced(const Mesh& mesh);

}  // namespace csg::reference
