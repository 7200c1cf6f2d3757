// The uniform block of gl/view.glsl.
#pragma once

#include "base/camera.h"
#include "gl/objects.h"

namespace gl {

/// What shaders know of a view, in the block's layout (std140); the names are those of gl/view.glsl.
struct ViewValues {
    glm::mat4 clip_from_local;
    glm::mat4 eye_from_world;
    glm::vec4 picture;
    glm::vec4 depth_range;
    glm::vec4 local_centre;
};

/// `local_centre`: world position of the local origin; `diagonal`: the scene's size.
[[nodiscard]] ViewValues view_values(const base::View& view, const glm::dvec3& local_centre, double diagonal);

/// Binding point 0 of uniform blocks, for every program that includes gl/view.glsl.
class ViewBlock {
  public:
    explicit ViewBlock(const Functions& gl) : buffer_(gl) {}
    /// See view_values.
    void update(const base::View& view, const glm::dvec3& local_centre, double diagonal);
    void bind() const { buffer_.bind(GL_UNIFORM_BUFFER, 0); }

  private:
    Buffer buffer_;
};

}  // namespace gl
