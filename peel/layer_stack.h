// The stack of layers, as npr/ and ui/ read it.
#pragma once

#include "gl/shader_file.h"
#include "goldfeather/layer_stack.h"

namespace peel {

using goldfeather::HostLayers;
using goldfeather::LayerStack;
using goldfeather::read_back;
using goldfeather::Surface;

/// Binds `stack` for shaders that include peel/layer_stack.glsl: texture units 0 and 1, storage blocks 0 and 1.
void bind(const LayerStack& stack);

/// This folder's shader files.
[[nodiscard]] std::span<const gl::ShaderFile> shader_files();

}  // namespace peel
