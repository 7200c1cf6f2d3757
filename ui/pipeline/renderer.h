// Draws models: from a Model to a picture, in one OpenGL context.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/camera.h"
#include "gl/context.h"
#include "gl/image.h"
#include "npr/accumulate.h"
#include "npr/color_scheme.h"
#include "npr/style.h"
#include "peel/peeler.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/statistics.h"

namespace ui {

struct PictureRequest {
    gl::Camera camera;
    glm::ivec2 size{512, 512};
    std::string style = "shaded";
    std::vector<std::pair<std::string, std::string>> settings;  ///< Style parameters by name; the rest are defaults.
    std::string scheme = "Cornfield";
    int layers = -1;  ///< 0: all; below 0: what the style needs.
    int samples = 4;  ///< Per pixel.
    bool transparent_background = false;
};

/// Throws std::runtime_error where there is no such style, parameter, value or scheme; names the nearest one.
void check_picture(const PictureRequest& request);

/// Holds one model on the GPU and the programs of all styles. Its context must be current whenever it is used, and
/// outlive it. Throws gl::Error where OpenGL cannot give what a picture needs, and ModelError where the engine asked
/// for cannot draw the model.
class Renderer {
  public:
    /// `engine`: absent to let the renderer choose.
    explicit Renderer(const gl::Context& context, std::optional<goldfeather::EngineKind> engine = {});

    /// The picture in main memory.
    [[nodiscard]] gl::Image render(const Model& model, const PictureRequest& request);

    /// The same step by step, so that the caller may look after other things in between: draws one of the picture's
    /// `samples`, the first (0) of a new picture; then `resolve` writes the mean of those drawn so far into `target`.
    void draw_sample(const Model& model, const PictureRequest& request, int sample);
    void resolve(GLuint target, glm::ivec2 corner) { accumulator_.resolve(target, corner); }
    /// … or gives it in main memory.
    [[nodiscard]] gl::Image image() { return accumulator_.image(); }

    /// The nearest point of the solid (world coordinates) in the middle of the camera's picture of one pixel; none
    /// where there is nothing.
    [[nodiscard]] std::optional<glm::dvec3> pick(const Model& model, const gl::Camera& camera);

    /// Of the last picture.
    [[nodiscard]] const PictureStatistics& statistics() const { return statistics_; }

  private:
    void hold(const Model& model);
    npr::Style& style(const npr::StyleInfo& info);
    void accumulate(const Model& model, const PictureRequest& request);

    const gl::Functions& gl_;
    bool software_;
    std::optional<goldfeather::EngineKind> wanted_;
    goldfeather::EngineChoice choice_;  ///< For the model held.
    peel::Peeler peeler_;
    npr::Accumulator accumulator_;
    std::map<std::string, std::unique_ptr<npr::Style>> styles_;  ///< Made when first used.
    std::unique_ptr<peel::PeelModel> model_;
    std::uint64_t generation_ = 0;  ///< Of the model that `model_` holds.
    bool translucent_ = false;      ///< Whether something in that model is not opaque.
    PictureStatistics statistics_;
};

}  // namespace ui
