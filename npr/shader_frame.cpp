#include "npr/shader_frame.h"

namespace npr::shader {

Frame::Frame(const CpuFrame& frame)
    : FrameValues(frame_values(frame.picture, frame.view, frame.layers.table->local_center,
                               frame.layers.table->diagonal, frame.layers.layers)),
      view(base::view_values(frame.view, frame.layers.table->local_center, frame.layers.table->diagonal)),
      leaf_rows(frame.layers.table->leaves.data()),
      part_looks(frame.layers.table->parts.data()),
      plane_rows(frame.layers.table->planes.data()),
      group_words(frame.layers.table->groups.data()),
      facet_starts(frame.layers.table->smooth.starts),
      smooth_facets(frame.layers.table->smooth.facets.data()),
      size(frame.layers.size),
      srgb(&SrgbTables::get()),
      shine(frame.shine),
      shadows(frame.shadows) {
    shadows_known = !shadows.empty();
    MediumTable media = media_of(frame.picture, frame.layers.table->parts, frame.layers.table->diagonal);
    medium_unit = media.unit;
    medium_rows = std::move(media.rows);
    for (int i = 0; i < layer_count; ++i) {
        const layers::HostLayer& layer = frame.layers.planes[static_cast<std::size_t>(i)];
        surfaces.push_back(layer.surface.data());
        depths.push_back(layer.depth.data());
    }
}

bool Frame::same_surfaces(ivec2 p, ivec2 q) const {
    for (int i = 0; i < layer_count; ++i) {
        const uvec2 a = surface_ids(p, i);
        if (a != surface_ids(q, i)) {
            return false;
        }
        if (a.x == kNoSurface) {
            break;
        }
        if (section_spacing > 0.0F && leaf_rows[a.x >> 1U].part.z != 0) {
            return false;  // Its hatching differs.
        }
    }
    return true;
}

bool Frame::sees_curves(ivec2 p) const {
    for (int i = 0; i < layer_count; ++i) {
        const uvec2 ids = surface_ids(p, i);
        if (ids.x == kNoSurface) {
            break;
        }
        if (facet_start(ids.y >> 1U) != facet_start((ids.y >> 1U) + 1)) {
            return true;
        }
    }
    return false;
}

}  // namespace npr::shader
