// The surface of a scene's solid among the cells of a complex.
#pragma once

#include <span>
#include <vector>

#include "csg/reference/cell_complex.h"
#include "csg/reference/mesh.h"

namespace csg::reference {

/// The leaves of the solid parts that have triangles, sorted.
[[nodiscard]] std::vector<LeafId> leaves_of(const Scene& scene, const solid::Geometry& geometry);

/// The cells with the solid on one side only, as triangles that face away from it; each knows the leaf whose surface it
/// is (docs/ENGINES.md). Sheets that only touch are apart (manifold.h).
[[nodiscard]] Mesh surface(const Scene& scene, std::span<const LeafId> leaves, const CellComplex& complex,
                           std::vector<glm::dvec3> points);

}  // namespace csg::reference
