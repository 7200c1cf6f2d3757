#include "npr/style_pass.h"

#include "base/stop.h"

namespace npr {
namespace {

/// That are drawn at once where it may have to stop in between.
constexpr int kPieceRows = 32;

}  // namespace

StylePass::StylePass(const gl::Functions& gl, std::string_view fragment, const OwnShaders& own)
    : gl_(gl), program_(gl, {"peel/fullscreen.vert", fragment}, own), empty_array_(gl) {}

void StylePass::draw(const Frame& frame, const gl::Framebuffer& target) {
    program_.use(frame);
    target.bind();
    gl_.Viewport(0, 0, frame.layers.size.x, frame.layers.size.y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_SCISSOR_TEST);
    empty_array_.bind();
    if (!frame.stop.stop_possible()) {
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
        return;
    }
    gl_.Enable(GL_SCISSOR_TEST);
    for (int row = 0; row < frame.layers.size.y && !frame.stop.stop_requested(); row += kPieceRows) {
        gl_.Scissor(0, row, frame.layers.size.x, kPieceRows);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
        gl_.Finish();
    }
    gl_.Disable(GL_SCISSOR_TEST);
    base::end_if_asked(frame.stop);
}

}  // namespace npr
