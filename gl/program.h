// Shader programs from embedded files.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "gl/objects.h"

namespace gl {

/// Where programs find their files: the embedded shaders of the folders that were added.
class ShaderLibrary {
  public:
    void add(std::span<const ShaderFile> files) { files_.insert(files_.end(), files.begin(), files.end()); }
    /// Throws gl::Error where there is no such file.
    [[nodiscard]] const ShaderFile& find(std::string_view name) const;
    [[nodiscard]] const std::vector<ShaderFile>& files() const { return files_; }

  private:
    std::vector<ShaderFile> files_;
};

/// A name and value put before the first line of every stage as `#define NAME VALUE`.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// A linked program. The stage follows from a file's extension: .vert, .frag, .comp.
/// `#include "folder/file.glsl"` is resolved, once per file; errors name the file and line.
class Program : public Name {
  public:
    Program() = default;
    /// Throws gl::Error with the driver's log where it does not compile or link.
    Program(const Functions& gl, const ShaderLibrary& library, std::initializer_list<std::string_view> files,
            const Defines& defines = {});
    Program(Program&&) noexcept = default;
    Program& operator=(Program&&) noexcept = default;
    ~Program();

    void use() const { gl_->UseProgram(id_); }

    // Uniforms by name. One that the shaders declare and do not use is ignored; a name that none of them declares is a
    // programmer's error: std::logic_error, in every build, as it costs one search of a set per name and program.
    void set(const char* name, int v) const { gl_->ProgramUniform1i(id_, at(name), v); }
    void set(const char* name, unsigned v) const { gl_->ProgramUniform1ui(id_, at(name), v); }
    void set(const char* name, float v) const { gl_->ProgramUniform1f(id_, at(name), v); }
    void set(const char* name, bool v) const { gl_->ProgramUniform1i(id_, at(name), v ? 1 : 0); }
    void set(const char* name, const glm::ivec2& v) const { gl_->ProgramUniform2iv(id_, at(name), 1, &v.x); }
    void set(const char* name, const glm::vec2& v) const { gl_->ProgramUniform2fv(id_, at(name), 1, &v.x); }
    void set(const char* name, const glm::vec3& v) const { gl_->ProgramUniform3fv(id_, at(name), 1, &v.x); }
    void set(const char* name, const glm::vec4& v) const { gl_->ProgramUniform4fv(id_, at(name), 1, &v.x); }
    void set(const char* name, const glm::mat4& v) const {
        gl_->ProgramUniformMatrix4fv(id_, at(name), 1, GL_FALSE, &v[0].x);
    }

  private:
    [[nodiscard]] GLint at(const char* name) const;
    std::string files_;                         ///< The stages' names, for errors.
    std::unordered_set<std::string> declared_;  ///< Uniforms, blocks and what follows "uniform" in a comment.
    mutable std::unordered_map<std::string, GLint> locations_;
};

}  // namespace gl
