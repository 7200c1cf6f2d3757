// What shaders know of a view.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"

namespace base {

/// In the layout (std140) of the block of gl/view.glsl, under its names.
struct ViewValues {
    glm::mat4 clip_from_local;
    glm::mat4 eye_from_world;
    glm::vec4 picture;
    glm::vec4 depth_range;
    glm::vec4 local_center;
};

/// `local_center`: world position of the local origin; `diagonal`: the scene's size.
[[nodiscard]] ViewValues view_values(const View& view, const glm::dvec3& local_center, double diagonal);

}  // namespace base
