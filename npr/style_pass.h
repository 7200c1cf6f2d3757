// What the passes of styles have in common.
#pragma once

#include <string_view>

#include "gl/program.h"
#include "gl/view_block.h"
#include "npr/style.h"

namespace npr {

/// The shader files of this folder.
[[nodiscard]] std::span<const gl::ShaderFile> shader_files();

/// A fragment program that draws the whole picture. It may include peel/layer_stack.glsl, gl/view.glsl and
/// npr/frame.glsl, for which draw() binds and sets everything.
class StylePass {
  public:
    /// `fragment`: file name from the repository's root, such as "npr/shaded.frag". Throws gl::Error.
    StylePass(const gl::Functions& gl, std::string_view fragment, const gl::Defines& defines = {});

    /// For the fragment program's own uniforms. Texture units from 2 and storage blocks from 2 are free.
    [[nodiscard]] const gl::Program& program() const { return program_; }
    void draw(const Frame& frame) { draw(frame, frame.target); }
    /// Into another target of the picture's size.
    void draw(const Frame& frame, const gl::Framebuffer& target);

  private:
    const gl::Functions& gl_;
    gl::Program program_;
    gl::VertexArray empty_array_;
    gl::ViewBlock view_block_;
};

}  // namespace npr
