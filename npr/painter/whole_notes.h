// Notes of styles that draw a pixel's layers as a whole.
#pragma once

#include "npr/painter/cpu_frame.h"

namespace npr {

class WholeNotes {
  public:
    /// `frame` must outlive the object.
    explicit WholeNotes(const CpuFrame& frame) : layers_(frame.layers) {}

    /// Of a pixel's color: linear light, premultiplied alpha. It lies where the first surface does; beside the
    /// silhouette, where strokes stray, where the nearest one nearby does (Nienhaus 2005, 6.4).
    [[nodiscard]] Note note(glm::ivec2 pixel, const glm::vec4& color) const;

  private:
    const layers::HostStack& layers_;
};

/// Premultiplied linear light as sRGB with straight alpha.
[[nodiscard]] glm::vec4 straight_srgb(const glm::vec4& light);

}  // namespace npr
