#include "npr/painter/cpu_shine.h"

#include "base/parallel.h"
#include "npr/shader_frame.h"
#include "npr/shine/shine.h"
#include "npr/shine/view_dependent_settings.h"

namespace npr {
namespace shader {

struct ShineFrame : Frame {
    using Frame::Frame;
#include "npr/plane_lookup.glsl"
#include "npr/planes.glsl"

#include "npr/shine/shine_rules.glsl"
};

}  // namespace shader

std::vector<ShineRow> find_shine(const CpuFrame& frame) {
    const glm::ivec2 size = frame.layers.size;
    const auto settings = transparency_settings<ViewDependentSettings>(frame.picture);
    const bool stop_at_back = settings.method == static_cast<int>(ShineMethod::BackFace);
    const auto width = static_cast<std::size_t>(size.x);
    std::vector<ShineSource> sources(width * static_cast<std::size_t>(size.y));
    base::for_each_index(
        size.y,
        [&] {
            return [&, rules = shader::ShineFrame(frame)](int y) mutable {
                for (int x = 0; x < size.x; ++x) {
                    sources[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
                        rules.shine_source({x, y}, stop_at_back);
                }
            };
        },
        0, frame.stop);
    const layers::SurfaceTable& table = *frame.layers.table;
    return shine_rows(frame.picture, frame.view, table.parts, table.local_center, sources, frame.mesh);
}

}  // namespace npr
