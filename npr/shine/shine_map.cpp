#include "npr/shine/shine_map.h"

#include "npr/shine/shine.h"
#include "npr/shine/view_dependent_settings.h"

namespace npr {

ShineMap::ShineMap(const gl::Functions& gl)
    : gl_(gl), find_(gl, {"npr/shine/shine_map.comp"}), sources_(gl), rows_(gl) {}

const gl::Buffer& ShineMap::draw(const Frame& frame) {
    const glm::ivec2 size = frame.layers.size;
    std::vector<ShineSource> sources(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const std::size_t bytes = sources.size() * sizeof(ShineSource);
    if (sources_.size() != bytes) {
        sources_.reserve(bytes, GL_DYNAMIC_READ);
    }
    const auto settings = transparency_settings<ViewDependentSettings>(frame.picture);
    find_.program().set("stop_at_back", settings.method == static_cast<int>(ShineMethod::BackFace));
    sources_.bind(GL_SHADER_STORAGE_BUFFER, 17);
    find_.use(frame);
    gl_.DispatchCompute((static_cast<GLuint>(size.x) + 63) / 64, static_cast<GLuint>(size.y), 1);
    gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl_.GetNamedBufferSubData(sources_.id(), 0, static_cast<GLsizeiptr>(bytes), sources.data());
    const layers::SurfaceBuffers& table = *frame.layers.table;
    rows_.upload<ShineRow>(shine_rows(frame.picture, frame.view, table.parts, table.local_center, sources, frame.mesh),
                           GL_DYNAMIC_DRAW);
    return rows_;
}

}  // namespace npr
