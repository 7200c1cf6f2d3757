// Two stacks of layers as one.
#pragma once

#include <optional>

#include "gl/program.h"
#include "layers/texture_stack.h"

namespace peel {

/// Merges stacks by depth. One per context.
class Merge {
  public:
    /// `gl` must outlive the object.
    explicit Merge(const gl::Functions& gl);

    /// The first `max_layers` surfaces of both (0: all), which must be of one size; at equal depth those of `front`
    /// come first. Its table is that of `front`. Throws gl::Error where the program does not compile.
    [[nodiscard]] layers::TextureStack operator()(const layers::TextureStack& front, const layers::TextureStack& back,
                                                  int max_layers);

  private:
    const gl::Functions& gl_;
    std::optional<gl::Program> program_;  ///< Made when first used.
    gl::VertexArray empty_array_;
    gl::Framebuffer target_;
    gl::Texture target_color_;
};

}  // namespace peel
