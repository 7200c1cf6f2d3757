// Draws models: from a Model to a picture.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/image.h"
#include "gl/context.h"
#include "ui/pipeline/picture/cpu_renderer.h"
#include "ui/pipeline/picture/gl_renderer.h"
#include "ui/pipeline/picture/pick.h"
#include "ui/pipeline/picture/picture_request.h"
#include "ui/pipeline/statistics.h"

namespace ui {

enum class Painter {
    Auto,    ///< OpenGL where a GPU computes it or the engine needs it, else the CPU.
    Cpu,     ///< No OpenGL; std::runtime_error where the engine needs it.
    OpenGl,  ///< OpenGL throughout.
};

/// Holds one model, ready to be drawn by OpenGL or without it. Throws gl::Error where OpenGL cannot give what a picture
/// needs, ModelError where the engine asked for cannot draw the model, and base::Stopped some milliseconds after a stop
/// is asked for; the picture must be begun anew then.
class Renderer {
  public:
    /// With a context, which must be current whenever the renderer is used, and outlive it.
    explicit Renderer(const gl::Context& context, const goldfeather::EngineOptions& engine = {},
                      Painter painter = Painter::Auto);
    /// Without one: made when a picture is the first to need it, and current from then on in the calling thread.
    explicit Renderer(const goldfeather::EngineOptions& engine = {}, Painter painter = Painter::Auto);

    /// The picture in main memory.
    [[nodiscard]] base::Image render(const Model& model, const PictureRequest& request,
                                     const std::stop_token& stop = {});

    /// The same step by step, so that the caller may look after other things in between: draws one of the picture's
    /// `samples`, the first (0) of a new picture; then `image` gives the mean of those drawn so far …
    void draw_sample(const Model& model, const PictureRequest& request, int sample, const std::stop_token& stop = {});
    [[nodiscard]] base::Image image();
    /// The same by pixel, rows from bottom to top: linear light, premultiplied alpha.
    [[nodiscard]] std::vector<glm::vec4> light() const { return on_cpu_ ? cpu_.light() : gl_->light(); }
    /// … or, where OpenGL drew them, `resolve` writes it into `target`.
    [[nodiscard]] bool drawn_with_opengl() const { return !on_cpu_; }
    void resolve(GLuint target, glm::ivec2 corner) { gl_->resolve(target, corner); }

    /// The surfaces in the middle of the camera's picture of one pixel (see pixel_camera): the first `layers`, nearest
    /// first (0: all).
    [[nodiscard]] std::vector<PickedSurface> pick(const Model& model, const base::Camera& camera, int layers = 1);

    /// The first layer of a whole view, …
    [[nodiscard]] std::shared_ptr<const layers::HostStack> first_layer(const Model& model, const base::View& view) {
        return peel(model, view, 1);
    }
    /// … or so many, nearest first (0: all).
    [[nodiscard]] std::shared_ptr<const layers::HostStack> first_layers(const Model& model, const base::View& view,
                                                                        int layers) {
        return peel(model, view, layers);
    }

    /// An EditableModel has changed in place. To be told by each commit to every renderer that may have drawn it,
    /// before it draws it again; what it holds of the model is made good as far as it can be, instead of being made
    /// anew.
    void update(const Model& model, const csg::solid::SceneChange& change);

    /// Of the last picture.
    [[nodiscard]] const PictureStatistics& statistics() const { return statistics_; }
    /// Null where no picture has needed one.
    [[nodiscard]] const gl::Context* context() const { return context_; }

  private:
    /// Sets choice_; is the CPU to draw it? `engine`: null where it is for wanted_ to say. `layers`: 0 for all.
    bool choose_cpu(const Model& model, const goldfeather::EngineInfo* engine, int layers);
    GlRenderer& with_opengl();
    [[nodiscard]] std::shared_ptr<const layers::HostStack> peel(const Model& model, const base::View& view, int layers);

    goldfeather::EngineOptions wanted_;
    Painter painter_;
    std::unique_ptr<gl::Context> own_context_;
    const gl::Context* context_ = nullptr;
    goldfeather::EngineChoice choice_;  ///< For the last picture.
    CpuRenderer cpu_;
    std::unique_ptr<GlRenderer> gl_;  ///< Made when first used.
    bool peeled_on_cpu_ = false;      ///< Who made the layers of the last picture, …
    bool on_cpu_ = false;             ///< … and who drew it.
    PictureStatistics statistics_;
};

}  // namespace ui
