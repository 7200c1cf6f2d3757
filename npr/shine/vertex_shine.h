// View-dependent transparency by vertices, as in the paper: beside distances by pixel, for comparison.
#pragma once

#include <span>
#include <vector>

#include "base/camera.h"
#include "layers/surface_table.h"
#include "npr/colored_mesh.h"
#include "npr/shine/shine_row.h"

namespace npr {

/// How far a picture's surfaces have cleared, by pixel, as the vertices of the nearest triangle toward the eye have it,
/// of the part that is seen through there (ShineSource::front_key): (distance to the nearest silhouette edge of the
/// part / farthest corner of the part from its center)^falloff, all in the world (Diepstraten, Weiskopf and Ertl 2002,
/// section 5). 0 where there is no such triangle.
[[nodiscard]] std::vector<float> clearness_by_vertex(const ColoredMesh& mesh, const base::View& view,
                                                     std::span<const layers::PartLook> parts, float falloff,
                                                     std::span<const ShineSource> sources);

}  // namespace npr
