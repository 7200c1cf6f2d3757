// The uniform block of gl/view.glsl.
#pragma once

#include "gl/camera.h"
#include "gl/objects.h"

namespace gl {

/// Binding point 0 of uniform blocks, for every program that includes gl/view.glsl.
class ViewBlock {
  public:
    explicit ViewBlock(const Functions& gl) : buffer_(gl) {}
    /// `local_centre`: world position of the local origin; `diagonal`: the scene's size.
    void update(const View& view, const glm::dvec3& local_centre, double diagonal);
    void bind() const { buffer_.bind(GL_UNIFORM_BUFFER, 0); }

  private:
    Buffer buffer_;
};

}  // namespace gl
