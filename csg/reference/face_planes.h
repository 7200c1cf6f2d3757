// Planes of a mesh's triangles, found such that thin triangles do not name planes of their own.
#pragma once

#include <span>
#include <vector>

#include "csg/solid/plane_table.h"

namespace csg::reference {

/// For each triangle its plane in the table, to which the planes are added: large triangles first, as they know theirs
/// best. A triangle as thin as the table's tolerance has no plane worth the name and takes a neighbor's, where it lies
/// in it.
[[nodiscard]] std::vector<solid::PlaneRef> face_planes(std::span<const glm::dvec3> points,
                                                       std::span<const glm::uvec3> triangles, solid::PlaneTable& table);

/// For each directed edge, 3 t + k from corner k of triangle t, the one that runs back; kNoTwin where there is none, or
/// more than one, or the edge itself occurs twice.
inline constexpr std::uint32_t kNoTwin = ~std::uint32_t{0};
[[nodiscard]] std::vector<std::uint32_t> twins_of(std::span<const glm::uvec3> triangles);

}  // namespace csg::reference
