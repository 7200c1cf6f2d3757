// The surface of the solid among the cells of a complex.
#pragma once

#include <functional>
#include <stop_token>

#include "csg/reference/mesh.h"
#include "csg/reference/region_values.h"

namespace csg::reference {

/// The cells with the solid on one side only, as triangles that face away from it; each knows the leaf whose surface it
/// is (docs/ENGINES.md). Sheets that only touch are apart (manifold.h), and what a leaf has of a plane in one piece has
/// no more triangles than its outline needs (flat_areas.h). `place(i)`: where point i of so many is; asked of those
/// that are on the surface. `normal(i)`: of plane i, of any length.
[[nodiscard]] Mesh surface(const CellComplex& complex, const RegionValues& values, std::size_t points,
                           const std::function<glm::dvec3(std::uint32_t)>& place,
                           const std::function<glm::dvec3(std::uint32_t)>& normal, const std::stop_token& stop);

}  // namespace csg::reference
