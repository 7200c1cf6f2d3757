// This folder's shader files.
#pragma once

#include <span>

#include "gl/shader_file.h"

namespace peel {

[[nodiscard]] std::span<const gl::ShaderFile> shader_files();

}  // namespace peel
