#include "npr/shader_frame.h"

namespace npr::shader {

Frame::Frame(const CpuFrame& frame)
    : view(base::view_values(frame.view, frame.layers.table->local_centre, frame.layers.table->diagonal)),
      layer_count(frame.layers.layers),
      // In double precision, since the world's origin may be far away.
      centre_in_eye(dvec3(frame.view.eye_from_world() * dvec4(frame.layers.table->local_centre, 1.0))),
      jitter(frame.view.jitter()),
      background_color(frame.scheme.background),
      background_stop(frame.scheme.background_stop),
      face_color(frame.scheme.face),
      cut_color(frame.scheme.cut),
      highlight_color(frame.scheme.highlight),
      ghost_color(frame.scheme.ghost),
      transparent_background(frame.transparent_background),
      leaf_rows(frame.layers.table->leaves.data()),
      plane_rows(frame.layers.table->planes.data()),
      size(frame.layers.size),
      srgb(&SrgbTables::get()) {
    for (int i = 0; i < layer_count; ++i) {
        const layers::HostLayer& layer = frame.layers.planes[static_cast<std::size_t>(i)];
        surfaces.push_back(layer.surface.data());
        depths.push_back(layer.depth.data());
    }
}

bool Frame::same_surfaces(ivec2 p, ivec2 q) const {
    for (int i = 0; i < layer_count; ++i) {
        const uvec2 a = surface_ids(p, i);
        if (a != surface_ids(q, i))
            return false;
        if (a.x == kNoSurface)
            break;
    }
    return true;
}

}  // namespace npr::shader
