// The surface of a scene's solid among the cells of a complex.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "csg/reference/cell_complex.h"
#include "csg/reference/mesh.h"

namespace csg::reference {

/// The leaves of the solid parts that have triangles, sorted.
[[nodiscard]] std::vector<LeafId> leaves_of(const Scene& scene, const solid::Geometry& geometry);

/// The cells with the solid on one side only, as triangles that face away from it; each knows the leaf whose surface it
/// is (docs/ENGINES.md). Sheets that only touch are apart (manifold.h). `place(i)`: where point i of so many is; asked
/// of those that are on the surface.
[[nodiscard]] Mesh surface(const Scene& scene, std::span<const LeafId> leaves, const CellComplex& complex,
                           std::size_t points, const std::function<glm::dvec3(std::uint32_t)>& place);

}  // namespace csg::reference
