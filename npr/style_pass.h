// Passes of styles that draw the whole picture.
#pragma once

#include "npr/frame_program.h"

namespace npr {

/// A fragment program that draws the whole picture.
class StylePass {
  public:
    /// `fragment`: file name from the repository's root, such as "npr/styles/shaded.frag". Throws gl::Error.
    StylePass(const gl::Functions& gl, std::string_view fragment, const OwnShaders& own = {});

    /// For the fragment program's own uniforms.
    [[nodiscard]] const gl::Program& program() const { return program_.program(); }
    /// Sets the uniforms of a style's settings (npr/settings.h).
    template <typename Settings>
    void set(const Settings& settings) const {
        Settings::table().set_uniforms(program(), settings);
    }
    /// Throws base::Stopped where the frame is asked to.
    void draw(const Frame& frame) { draw(frame, frame.target); }
    /// Into another target of the picture's size.
    void draw(const Frame& frame, const gl::Framebuffer& target);

  private:
    const gl::Functions& gl_;
    FrameProgram program_;
    gl::VertexArray empty_array_;
};

}  // namespace npr
