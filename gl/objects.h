// Move-only owners of OpenGL objects, made through direct state access.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "gl/functions.h"
#include "gl/shader_file.h"

namespace gl {

/// An owned name of an OpenGL object; 0 where there is none.
class Name {
  public:
    Name() = default;
    Name(const Functions& gl, GLuint id) : gl_(&gl), id_(id) {}
    Name(Name&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(id_, other.id_);
        return *this;
    }
    [[nodiscard]] GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  protected:
    ~Name() = default;
    const Functions* gl_ = nullptr;
    GLuint id_ = 0;
};

/// A buffer of bytes on the GPU.
class Buffer : public Name {
  public:
    Buffer() = default;
    explicit Buffer(const Functions& gl);
    Buffer(Buffer&&) noexcept = default;
    Buffer& operator=(Buffer&&) noexcept = default;
    ~Buffer();

    /// Replaces the content; at least 16 bytes are allocated, so that an empty buffer can be bound.
    template <typename T>
    void upload(std::span<const T> data, GLenum usage = GL_STATIC_DRAW) {
        upload_bytes(data.data(), data.size_bytes(), usage);
    }
    void upload_bytes(const void* data, std::size_t size, GLenum usage);
    /// Replaces bytes from `offset` on; they must be there.
    template <typename T>
    void write(std::size_t offset, std::span<const T> data) {
        write_bytes(offset, data.data(), data.size_bytes());
    }
    void write_bytes(std::size_t offset, const void* data, std::size_t size);
    /// Allocates `size` bytes of undefined content.
    void reserve(std::size_t size, GLenum usage);
    void bind(GLenum target, GLuint index) const { gl_->BindBufferBase(target, index, id_); }
    [[nodiscard]] std::size_t size() const { return size_; }

  private:
    std::size_t size_ = 0;
};

/// A texture with immutable storage and one level, sampled nearest, clamped to its edge unless told otherwise.
class Texture : public Name {
  public:
    Texture() = default;
    static Texture make_2d(const Functions& gl, GLenum format, glm::ivec2 size);
    static Texture make_2d_array(const Functions& gl, GLenum format, glm::ivec2 size, int layers);
    /// Views `buffer` as texels of `format`; the buffer must outlive the texture.
    static Texture make_buffer(const Functions& gl, GLenum format, const Buffer& buffer);
    Texture(Texture&&) noexcept = default;
    Texture& operator=(Texture&&) noexcept = default;
    ~Texture();

    void bind(GLuint unit) const { gl_->BindTextureUnit(unit, id_); }
    void set_filter(GLenum filter) const;
    void set_wrap(GLenum wrap) const;
    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] int layers() const { return layers_; }
    [[nodiscard]] GLenum format() const { return format_; }

  private:
    Texture(const Functions& gl, GLenum target, GLenum format, glm::ivec2 size, int layers);
    GLenum format_ = 0;
    glm::ivec2 size_{0};
    int layers_ = 0;
};

/// A framebuffer; the textures attached to it are not owned.
class Framebuffer : public Name {
  public:
    Framebuffer() = default;
    explicit Framebuffer(const Functions& gl);
    Framebuffer(Framebuffer&&) noexcept = default;
    Framebuffer& operator=(Framebuffer&&) noexcept = default;
    ~Framebuffer();

    /// Attaches color targets 0, 1, … and, where given, a depth target. Throws gl::Error where it is incomplete.
    void attach(std::span<const Texture* const> colors, const Texture* depth = nullptr);
    void attach(std::initializer_list<const Texture*> colors, const Texture* depth = nullptr) {
        attach(std::span<const Texture* const>(colors.begin(), colors.size()), depth);
    }
    /// The same for one layer of each (array) color texture.
    void attach_layer(std::span<const Texture* const> colors, int layer);
    void bind() const { gl_->BindFramebuffer(GL_FRAMEBUFFER, id_); }

  private:
    void finish(std::size_t color_count);
    std::size_t attached_ = 0;
};

/// Counts samples (GL_SAMPLES_PASSED), tells whether any passed, or measures time.
class Query : public Name {
  public:
    Query() = default;
    Query(const Functions& gl, GLenum target);
    Query(Query&&) noexcept = default;
    Query& operator=(Query&&) noexcept = default;
    ~Query();

    void begin() const { gl_->BeginQuery(target_, id_); }
    void end() const { gl_->EndQuery(target_); }
    /// Waits for the result.
    [[nodiscard]] GLuint64 result() const;

  private:
    GLenum target_ = 0;
};

class VertexArray : public Name {
  public:
    VertexArray() = default;
    explicit VertexArray(const Functions& gl);
    VertexArray(VertexArray&&) noexcept = default;
    VertexArray& operator=(VertexArray&&) noexcept = default;
    ~VertexArray();
    void bind() const { gl_->BindVertexArray(id_); }
};

}  // namespace gl
