// What the noise of sketches lies on (Nienhaus 2005, 6.7): a smooth sheet over all that a picture sees first.
#pragma once

#include <span>
#include <vector>

#include "base/camera.h"

namespace npr {

/// Cells of a grid about the middle of the picture, rows from bottom to top.
struct Relief {
    glm::ivec2 size{0};            ///< Cells; even.
    float cell = 1;                ///< Pixels.
    std::vector<float> distances;  ///< From the eye's plane along the axis of view; world units.
};

/// `depths`: of the first layer by pixel, reversed, 0 where nothing is. Where near and far surfaces meet in a cell the
/// near ones count, as in geometry that is enlarged along its normals; beyond what is seen the sheet goes on smoothly.
/// `cell`: in pixels. `center`: the distance that it has where nothing is seen at all. `diagonal`: of the scene.
[[nodiscard]] Relief relief_of(const base::View& view, std::span<const float> depths, float cell, double center,
                               double diagonal);

}  // namespace npr
