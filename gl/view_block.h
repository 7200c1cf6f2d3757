// The uniform block of gl/view.glsl.
#pragma once

#include "base/view_values.h"
#include "gl/objects.h"

namespace gl {

/// Binding point 0 of uniform blocks, for every program that includes gl/view.glsl.
class ViewBlock {
  public:
    explicit ViewBlock(const Functions& gl) : buffer_(gl) {}
    /// See base::view_values.
    void update(const base::View& view, const glm::dvec3& local_center, double diagonal);
    void bind() const { buffer_.bind(GL_UNIFORM_BUFFER, 0); }

  private:
    Buffer buffer_;
};

}  // namespace gl
