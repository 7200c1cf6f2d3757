// This folder's shader files.
#pragma once

#include "gl/shader_file.h"

namespace goldfeather {

[[nodiscard]] std::span<const gl::ShaderFile> shader_files();

}  // namespace goldfeather
