#include "ui/viewer/picture_view.h"

#include <array>

namespace ui {

PictureView::PictureView(const gl::Context& context, std::optional<goldfeather::EngineKind> engine)
    : gl_(context.functions()), renderer_(context, engine), target_(gl_) {}

void PictureView::draw(const Model& model, const PictureRequest& request, const PictureStep& step) {
    PictureRequest scaled = request;
    scaled.size = glm::max((request.size + step.divisor - 1) / step.divisor, 1);
    renderer_.draw_sample(model, scaled, step.sample);
    if (!texture_ || texture_.size() != scaled.size) {
        texture_ = gl::Texture::make_2d(gl_, GL_RGBA8, scaled.size);
        target_.attach({&texture_});
    }
    renderer_.resolve(target_.id(), {0, 0});
    gl_.Finish();
    drawn_ = true;
}

void PictureView::show(glm::ivec2 corner, glm::ivec2 size, const glm::vec3& empty_color) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (!drawn_) {
        const std::array<float, 4> color{empty_color.r, empty_color.g, empty_color.b, 1};
        gl_.ClearNamedFramebufferfv(0, GL_COLOR, 0, color.data());
        return;
    }
    const glm::ivec2 drawn = texture_.size();
    const glm::ivec2 end = corner + size;
    gl_.BlitNamedFramebuffer(target_.id(), 0, 0, 0, drawn.x, drawn.y, corner.x, corner.y, end.x, end.y,
                             GL_COLOR_BUFFER_BIT, drawn == size ? GL_NEAREST : GL_LINEAR);
}

}  // namespace ui
