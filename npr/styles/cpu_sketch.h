// Sketches without OpenGL.
#pragma once

#include "npr/painter/cpu_frame.h"
#include "npr/styles/hand.h"

namespace npr {

/// Keeps the noise of the picture, and memory, from frame to frame.
[[nodiscard]] Paint make_sketch_paint(const Hand& hand);

}  // namespace npr
