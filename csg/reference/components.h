// Meshes taken apart and put together by their edges.
#pragma once

#include <span>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The pieces of a mesh: across an edge of two triangles a piece goes on, across an edge where more meet it does not,
/// nor across a corner. So solids that only touch are apart. Sources are kept.
[[nodiscard]] std::vector<Mesh> components_of(const Mesh& mesh);

/// The same surface with one point for each place and without triangles that have a corner twice. `sources`: by
/// triangle; all are 0 where there are none.
[[nodiscard]] Mesh welded(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
                          std::span<const std::uint32_t> sources = {});

/// Does each directed edge occur as often as its opposite? Of a welded mesh.
[[nodiscard]] bool balanced(const Mesh& mesh);

/// A point so far before the middle of the largest triangle, in world units.
[[nodiscard]] glm::dvec3 before(const Mesh& mesh, double distance);

}  // namespace csg::reference
