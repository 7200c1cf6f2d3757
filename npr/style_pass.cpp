#include "npr/style_pass.h"

namespace npr {

StylePass::StylePass(const gl::Functions& gl, std::string_view fragment, const gl::Defines& defines)
    : gl_(gl), program_(gl, {"peel/fullscreen.vert", fragment}, defines), empty_array_(gl) {}

void StylePass::draw(const Frame& frame, const gl::Framebuffer& target) {
    program_.use(frame);
    target.bind();
    gl_.Viewport(0, 0, frame.layers.size.x, frame.layers.size.y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_SCISSOR_TEST);
    empty_array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npr
