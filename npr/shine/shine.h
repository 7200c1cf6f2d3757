// View-dependent transparency: from silhouettes to opacity, for both painters.
#pragma once

#include <span>
#include <vector>

#include "base/camera.h"
#include "layers/surface_table.h"
#include "npr/colored_mesh.h"
#include "npr/picture.h"
#include "npr/shine/shine_row.h"

namespace npr {

/// For each pixel the distance, in pixels, to the nearest pixel of the same part that a silhouette is next to, exactly
/// (Meijster, Roerdink and Hesselink 2000); negative where there is none. `keys`: by pixel, as ShineSource has them.
[[nodiscard]] std::vector<float> silhouette_distances(glm::ivec2 size, std::span<const glm::uint> keys);

/// Pixels from the center of a part to the farthest point of its leaves, as seen from the view.
[[nodiscard]] float radius_in_pixels(const layers::PartLook& part, const base::View& view,
                                     const glm::dvec3& local_center);

/// `sources`: by pixel of a frame, of the view and the parts; `local_center`: of the parts. `mesh`: where opacity is
/// asked for by vertex; null: it is found by pixel all the same.
[[nodiscard]] std::vector<ShineRow> shine_rows(const Picture& picture, const base::View& view,
                                               std::span<const layers::PartLook> parts, const glm::dvec3& local_center,
                                               std::span<const ShineSource> sources, const ColoredMesh* mesh);

}  // namespace npr
