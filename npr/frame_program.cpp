#include "npr/frame_program.h"

#include <array>

#include "npr/frame_values.h"
#include "npr/medium_rows.h"
#include "peel/shaders.h"

namespace npr {
namespace {

gl::ShaderLibrary shaders(const OwnShaders& own) {
    gl::ShaderLibrary library;
    library.add(gl::shader_files());
    library.add(layers::shader_files());
    library.add(peel::shader_files());
    library.add(npr::shader_files());
    library.add(std::array{gl::ShaderFile{"npr/frame_values.glsl", FrameValues::table().declarations()},
                           gl::ShaderFile{"npr/settings.glsl", own.settings}});
    library.add(own.files);
    return library;
}

}  // namespace

FrameProgram::FrameProgram(const gl::Functions& gl, std::initializer_list<std::string_view> files,
                           const OwnShaders& own)
    : program_(gl, shaders(own), files, own.defines), view_block_(gl), media_(gl) {}

void FrameProgram::use(const Frame& frame) {
    view_block_.update(frame.view, frame.layers.table->local_center, frame.layers.table->diagonal);
    view_block_.bind();
    layers::bind(frame.layers);
    const layers::SurfaceBuffers& table = *frame.layers.table;
    const MediumTable media = media_of(frame.picture, table.parts, table.diagonal);
    media_.upload<MediumRow>(media.rows, GL_DYNAMIC_DRAW);
    media_.bind(GL_SHADER_STORAGE_BUFFER, 11);
    (frame.shine != nullptr ? *frame.shine : media_).bind(GL_SHADER_STORAGE_BUFFER, 16);
    (frame.shadows != nullptr ? *frame.shadows : media_).bind(GL_SHADER_STORAGE_BUFFER, 14);
    FrameValues values =
        frame_values(frame.picture, frame.view, table.local_center, table.diagonal, frame.layers.layers);
    values.medium_unit = media.unit;
    values.shadows_known = frame.shadows != nullptr;
    FrameValues::table().set_uniforms(program_, values);
    program_.use();
}

}  // namespace npr
