// View-dependent transparency drawn with OpenGL: which faces shine is found by a shader, distances by
// npr/shine/shine.h.
#pragma once

#include "npr/frame_program.h"

namespace npr {

class ShineMap {
  public:
    /// `gl` must outlive the object. Throws gl::Error.
    explicit ShineMap(const gl::Functions& gl);

    /// For Frame::shine; stands until the next call.
    [[nodiscard]] const gl::Buffer& draw(const Frame& frame);

  private:
    const gl::Functions& gl_;
    FrameProgram find_;
    gl::Buffer sources_, rows_;
};

}  // namespace npr
