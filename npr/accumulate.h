// Antialiasing: samples at several places in the pixel, each of its own stack of layers, averaged in linear light.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/camera.h"
#include "base/image.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "npr/samples.h"
#include "npr/shine/shine_map.h"
#include "npr/style.h"

namespace npr {

/// What pictures are drawn of.
struct Subject {
    glm::dvec3 lo{0}, hi{0};  ///< The box that encloses it, as base::View takes it.
    /// Its layers as seen from a view; called once per sample.
    std::function<layers::TextureStack(const base::View& view)> peel;
    const ColoredMesh* mesh = nullptr;  ///< Of the parts, for pictures that need it.
    FindShadows shadows{};              ///< For pictures that need them; none: nothing lies in a shadow.
};

/// Draws pictures sample by sample and keeps their sum. One per context, reused; `gl` must outlive it.
class Accumulator {
  public:
    explicit Accumulator(const gl::Functions& gl);

    /// All samples. `style`: made of the picture's.
    void draw(Style& style, const Picture& picture, const Subject& subject);
    /// One sample of sample_offsets(picture.samples); the first (0) begins a new picture. After each the picture is
    /// the mean of those drawn so far. Gives the sample's layers, for whoever can use their textures again. Throws
    /// base::Stopped where `stop` is asked for: begin with the first sample again.
    layers::TextureStack draw_sample(Style& style, const Picture& picture, std::size_t sample, const Subject& subject,
                                     const std::stop_token& stop = {});

    /// The picture drawn last by pixel, rows from bottom to top: linear light, premultiplied alpha.
    [[nodiscard]] std::vector<glm::vec4> light() const;
    /// The picture drawn last.
    [[nodiscard]] base::Image image();
    /// Writes the picture drawn last into `target` (0: the window) as sRGB with straight alpha, its lower left corner
    /// at `corner`. Replaces what was there.
    void resolve(GLuint target, glm::ivec2 corner);

  private:
    void resize(glm::ivec2 size);
    [[nodiscard]] glm::ivec2 shown() const { return sum_.size() - 2 * guard_; }

    const gl::Functions& gl_;
    gl::Program resolve_;
    gl::Program add_;
    gl::VertexArray empty_array_;
    gl::Texture sample_, sum_, resolved_;
    gl::Framebuffer sample_target_, sum_target_, resolved_target_;
    std::optional<ShineMap> shine_;      ///< Made when first needed.
    std::optional<gl::Buffer> shadows_;  ///< The same.
    int samples_ = 1;                    ///< In the sum.
    int guard_ = 0;                      ///< Of its pixels, at each side not shown.
};

}  // namespace npr
