#include "npr/style_pass.h"

namespace npr {
namespace {

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(gl::shader_files());
    library.add(peel::shader_files());
    library.add(npr::shader_files());
    return library;
}

}  // namespace

StylePass::StylePass(const gl::Functions& gl, std::string_view fragment, const gl::Defines& defines)
    : gl_(gl),
      program_(gl, shaders(), {"peel/fullscreen.vert", fragment}, defines),
      empty_array_(gl),
      view_block_(gl) {}

void StylePass::draw(const Frame& frame, const gl::Framebuffer& target) {
    view_block_.update(frame.view, frame.layers.tables->local_centre, frame.layers.tables->diagonal);
    view_block_.bind();
    peel::bind(frame.layers);
    program_.set("layer_count", frame.layers.layers);
    // In double precision, since the world's origin may be far away.
    program_.set("centre_in_eye", glm::vec3(glm::dvec3(frame.view.eye_from_world() *
                                                       glm::dvec4(frame.layers.tables->local_centre, 1.0))));
    program_.set("jitter", glm::vec2(frame.view.jitter()));
    program_.set("background_color", frame.scheme.background);
    program_.set("background_stop", frame.scheme.background_stop);
    program_.set("face_color", frame.scheme.face);
    program_.set("cut_color", frame.scheme.cut);
    program_.set("highlight_color", frame.scheme.highlight);
    program_.set("ghost_color", frame.scheme.ghost);
    program_.set("transparent_background", frame.transparent_background);

    target.bind();
    gl_.Viewport(0, 0, frame.layers.size.x, frame.layers.size.y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_SCISSOR_TEST);
    program_.use();
    empty_array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npr
