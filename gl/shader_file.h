// Shader sources are files beside the C++ that runs them, embedded at build time (cmake/embed_shaders.cmake).
#pragma once

#include <span>
#include <string_view>

namespace gl {

/// A file's path from the repository's root, and its text.
struct ShaderFile {
    std::string_view name;
    std::string_view text;
};

/// The shader files of this folder: parts that other folders' shaders #include.
[[nodiscard]] std::span<const ShaderFile> shader_files();

}  // namespace gl
