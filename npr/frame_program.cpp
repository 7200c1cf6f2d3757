#include "npr/frame_program.h"

#include "peel/shaders.h"

namespace npr {
namespace {

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(gl::shader_files());
    library.add(layers::shader_files());
    library.add(peel::shader_files());
    library.add(npr::shader_files());
    return library;
}

}  // namespace

FrameProgram::FrameProgram(const gl::Functions& gl, std::initializer_list<std::string_view> files,
                           const gl::Defines& defines)
    : program_(gl, shaders(), files, defines), view_block_(gl) {}

void FrameProgram::use(const Frame& frame) {
    view_block_.update(frame.view, frame.layers.table->local_centre, frame.layers.table->diagonal);
    view_block_.bind();
    layers::bind(frame.layers);
    program_.set("layer_count", frame.layers.layers);
    // In double precision, since the world's origin may be far away.
    program_.set("centre_in_eye", glm::vec3(glm::dvec3(frame.view.eye_from_world() *
                                                       glm::dvec4(frame.layers.table->local_centre, 1.0))));
    program_.set("jitter", glm::vec2(frame.view.jitter()));
    program_.set("background_color", frame.scheme.background);
    program_.set("background_stop", frame.scheme.background_stop);
    program_.set("face_color", frame.scheme.face);
    program_.set("cut_color", frame.scheme.cut);
    program_.set("highlight_color", frame.scheme.highlight);
    program_.set("ghost_color", frame.scheme.ghost);
    program_.set("transparent_background", frame.transparent_background);
    program_.use();
}

}  // namespace npr
