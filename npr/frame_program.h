// Programs of styles: what all of them know of a frame.
#pragma once

#include <span>
#include <string_view>

#include "gl/program.h"
#include "gl/view_block.h"
#include "npr/style.h"

namespace npr {

/// The shader files of this folder.
[[nodiscard]] std::span<const gl::ShaderFile> shader_files();

/// What a style adds to the shader files of this folder and those below.
struct OwnShaders {
    std::string_view settings{};              ///< "npr/settings.glsl": see SettingsTable.
    std::span<const gl::ShaderFile> files{};  ///< Of a style that is not in this folder.
    gl::Defines defines{};
};

/// A program that may include layers/layer_stack.glsl, gl/view.glsl and npr/frame.glsl. Texture units from 2, storage
/// blocks from 2 to 4 and all image units are free for its own use.
class FrameProgram {
  public:
    /// File names from the repository's root, such as "npr/styles/shaded.frag". Throws gl::Error.
    FrameProgram(const gl::Functions& gl, std::initializer_list<std::string_view> files, const OwnShaders& own = {});

    /// For the program's own uniforms.
    [[nodiscard]] const gl::Program& program() const { return program_; }
    /// Binds and sets everything that the included files need, and uses the program.
    void use(const Frame& frame);

  private:
    gl::Program program_;
    gl::ViewBlock view_block_;
    gl::Buffer media_;  ///< Of MediumRow.
};

}  // namespace npr
