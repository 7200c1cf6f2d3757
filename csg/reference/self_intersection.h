// The last check of a mesh: no two of its triangles cross.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// Whether triangles that overlap in one plane count. Where walls and gaps thinner than the tolerance are right, there
/// may be several of them upon each other, and every second faces the same way.
enum class Overlaps : std::uint8_t { Counted, Ignored };

/// The pairs of triangles that cross, or lie in one plane, face the same way and overlap, by more than `tolerance`
/// (world units): a coordinate rounded to double may push a corner through a face that it lies on, but not further.
/// Sheets that touch do not cross, nor do the two sides of a wall or a gap thinner than the tolerance. Where faces
/// cross, some edge of one passes through the inside of another triangle: that is what is looked for, so a crossing
/// that passes only through edges is not seen.
[[nodiscard]] std::size_t count_self_intersections(const Mesh& mesh, double tolerance,
                                                   Overlaps overlaps = Overlaps::Counted,
                                                   const std::stop_token& stop = {});

}  // namespace csg::reference
