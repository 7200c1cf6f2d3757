// The noise of sketches without OpenGL.
#pragma once

#include <optional>
#include <vector>

#include "npr/painter/cpu_frame.h"
#include "npr/styles/sketch_settings.h"

namespace npr {

/// The noise of a picture, kept while it stays the same: on the model for all of its samples, else for as long as no
/// other is asked for.
class CpuSketchNoise {
  public:
    void draw(const CpuFrame& frame, const SketchSettings& settings);

    // Of the frame drawn last, by pixel.
    /// See npr/styles/sketch_noise.glsl.
    [[nodiscard]] const glm::vec4& strokes(std::size_t pixel) const { return strokes_[pixel]; }
    /// See npr/styles/noise.glsl.
    [[nodiscard]] float grain(std::size_t pixel) const { return grain_[pixel]; }

  private:
    std::vector<glm::vec4> strokes_;
    std::vector<float> grain_;
    std::optional<NoiseKey> key_;
};

}  // namespace npr
