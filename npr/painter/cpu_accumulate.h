// Antialiasing without OpenGL: npr/accumulate.h for styles that paint.
#pragma once

#include <functional>
#include <vector>

#include "base/image.h"
#include "npr/painter/cpu_frame.h"
#include "npr/samples.h"

namespace npr {

/// What pictures are painted of: npr::Subject with layers in main memory.
struct CpuSubject {
    glm::dvec3 lo{0}, hi{0};  ///< The box that encloses it, as base::View takes it.
    /// Its layers as seen from a view, which must stand until the next call; called once per sample.
    std::function<const layers::HostStack&(const base::View& view)> peel;
    const ColoredMesh* mesh = nullptr;  ///< Of the parts, for pictures that need it.
    FindShadows shadows{};              ///< For pictures that need them; none: nothing lies in a shadow.
};

/// Paints pictures sample by sample and keeps their sum.
class CpuAccumulator {
  public:
    /// One sample of sample_offsets(picture.samples); the first (0) begins a new picture. After each the picture is the
    /// mean of those painted so far. `paint`: made of the picture's style. Throws base::Stopped where `stop` is asked
    /// for: begin with the first sample again.
    void paint_sample(const Paint& paint, const Picture& picture, std::size_t sample, const CpuSubject& subject,
                      const std::stop_token& stop = {});

    /// The picture painted last by pixel, rows from bottom to top: linear light, premultiplied alpha.
    [[nodiscard]] std::vector<glm::vec4> light() const;
    /// The same: sRGB with straight alpha.
    [[nodiscard]] base::Image image() const;

  private:
    /// Within the guard band.
    [[nodiscard]] const glm::vec4* shown_row(int y) const;

    glm::ivec2 size_{0};  ///< Of the sum, with the guard band.
    int guard_ = 0;
    int samples_ = 1;  ///< In the sum.
    std::vector<glm::vec4> sum_;
};

}  // namespace npr
