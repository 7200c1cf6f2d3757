// The model's picture in the window: drawn step by step into a texture, shown from there in every frame.
#pragma once

#include <optional>

#include "ui/pipeline/renderer.h"
#include "ui/viewer/frame_plan.h"

namespace ui {

/// The context must be current whenever this is used, and outlive it.
class PictureView {
  public:
    PictureView(const gl::Context& context, std::optional<goldfeather::EngineKind> engine);

    /// Draws one step of the picture that `request` asks for. Throws gl::Error.
    void draw(const Model& model, const PictureRequest& request, const PictureStep& step);
    /// Fills a rectangle of the window (pixels, from the lower left) with the picture, or with the colour where
    /// nothing has been drawn yet.
    void show(glm::ivec2 corner, glm::ivec2 size, const glm::vec3& empty_color) const;
    /// Forgets the picture.
    void clear() { drawn_ = false; }

    /// A picture of its own in main memory; the one that is shown must be begun anew afterwards.
    [[nodiscard]] gl::Image render(const Model& model, const PictureRequest& request) {
        return renderer_.render(model, request);
    }
    /// See Renderer::pick.
    [[nodiscard]] std::optional<glm::dvec3> pick(const Model& model, const gl::Camera& camera) {
        return renderer_.pick(model, camera);
    }
    [[nodiscard]] const PictureStatistics& statistics() const { return renderer_.statistics(); }

  private:
    const gl::Functions& gl_;
    Renderer renderer_;
    gl::Texture texture_;
    gl::Framebuffer target_;
    bool drawn_ = false;
};

}  // namespace ui
