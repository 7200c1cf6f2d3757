// The last check of a mesh: no two of its triangles cross.
#pragma once

#include <cstddef>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The pairs of triangles that cross, or lie in one plane and overlap, by more than `tolerance` (world units): a
/// coordinate rounded to double may push a corner through a face that it lies on, but not further. Sheets that touch
/// do not cross. Where faces cross, some edge of one passes through the inside of another triangle: that is what is
/// looked for, so a crossing that passes only through edges is not seen.
[[nodiscard]] std::size_t count_self_intersections(const Mesh& mesh, double tolerance,
                                                   const std::stop_token& stop = {});

}  // namespace csg::reference
