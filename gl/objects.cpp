#include "gl/objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>

#include "gl/error.h"

namespace gl {

Buffer::Buffer(const Functions& gl) : Name(gl, 0) {
    gl.CreateBuffers(1, &id_);
}
Buffer::~Buffer() {
    if (id_) {
        gl_->DeleteBuffers(1, &id_);
    }
}

void Buffer::reserve(std::size_t size, GLenum usage) {
    size_ = size;
    gl_->NamedBufferData(id_, static_cast<GLsizeiptr>(std::max<std::size_t>(size, 16)), nullptr, usage);
}

void Buffer::upload_bytes(const void* data, std::size_t size, GLenum usage) {
    reserve(size, usage);
    if (size) {
        gl_->NamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(size), data);
    }
}

void Buffer::write_bytes(std::size_t offset, const void* data, std::size_t size) {
    if (size) {
        gl_->NamedBufferSubData(id_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
    }
}

Texture::Texture(const Functions& gl, GLenum target, GLenum format, glm::ivec2 size, int layers)
    : Name(gl, 0), format_(format), size_(size), layers_(layers) {
    gl.CreateTextures(target, 1, &id_);
}

Texture Texture::make_2d(const Functions& gl, GLenum format, glm::ivec2 size) {
    Texture t(gl, GL_TEXTURE_2D, format, size, 1);
    gl.TextureStorage2D(t.id_, 1, format, size.x, size.y);
    t.set_filter(GL_NEAREST);
    t.set_wrap(GL_CLAMP_TO_EDGE);
    return t;
}

Texture Texture::make_2d_array(const Functions& gl, GLenum format, glm::ivec2 size, int layers) {
    Texture t(gl, GL_TEXTURE_2D_ARRAY, format, size, layers);
    gl.TextureStorage3D(t.id_, 1, format, size.x, size.y, layers);
    t.set_filter(GL_NEAREST);
    t.set_wrap(GL_CLAMP_TO_EDGE);
    return t;
}

Texture Texture::make_buffer(const Functions& gl, GLenum format, const Buffer& buffer) {
    Texture t(gl, GL_TEXTURE_BUFFER, format, {0, 0}, 1);
    gl.TextureBuffer(t.id_, format, buffer.id());
    return t;
}

Texture::~Texture() {
    if (id_) {
        gl_->DeleteTextures(1, &id_);
    }
}

void Texture::set_filter(GLenum filter) const {
    gl_->TextureParameteri(id_, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    gl_->TextureParameteri(id_, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
}

void Texture::set_wrap(GLenum wrap) const {
    gl_->TextureParameteri(id_, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
    gl_->TextureParameteri(id_, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
}

Framebuffer::Framebuffer(const Functions& gl) : Name(gl, 0) {
    gl.CreateFramebuffers(1, &id_);
}
Framebuffer::~Framebuffer() {
    if (id_) {
        gl_->DeleteFramebuffers(1, &id_);
    }
}

void Framebuffer::attach(std::span<const Texture* const> colors, const Texture* depth) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
        gl_->NamedFramebufferTexture(id_, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), colors[i]->id(), 0);
    }
    gl_->NamedFramebufferTexture(id_, GL_DEPTH_ATTACHMENT, depth ? depth->id() : 0, 0);
    finish(colors.size());
}

void Framebuffer::attach_layer(std::span<const Texture* const> colors, int layer) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
        gl_->NamedFramebufferTextureLayer(id_, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), colors[i]->id(), 0,
                                          layer);
    }
    finish(colors.size());
}

void Framebuffer::finish(std::size_t color_count) {
    for (std::size_t i = color_count; i < attached_; ++i) {
        gl_->NamedFramebufferTexture(id_, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), 0, 0);
    }
    attached_ = color_count;
    std::array<GLenum, 8> buffers{};
    for (std::size_t i = 0; i < color_count; ++i) {
        buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    }
    gl_->NamedFramebufferDrawBuffers(id_, static_cast<GLsizei>(color_count), buffers.data());
    const GLenum status = gl_->CheckNamedFramebufferStatus(id_, GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) {
        return;
    }
    // What could not be allocated before is told here first.
    constexpr int kKindsOfErrors = 8;
    for (int i = 0; i < kKindsOfErrors; ++i) {
        if (gl_->GetError() == GL_OUT_OF_MEMORY) {
            throw std::bad_alloc();
        }
    }
    throw Error(fmt::format("framebuffer incomplete (0x{:x})", status));
}

Query::Query(const Functions& gl, GLenum target) : Name(gl, 0), target_(target) {
    gl.CreateQueries(target, 1, &id_);
}
Query::~Query() {
    if (id_) {
        gl_->DeleteQueries(1, &id_);
    }
}

GLuint64 Query::result() const {
    GLuint64 value = 0;
    gl_->GetQueryObjectui64v(id_, GL_QUERY_RESULT, &value);
    return value;
}

VertexArray::VertexArray(const Functions& gl) : Name(gl, 0) {
    gl.CreateVertexArrays(1, &id_);
}
VertexArray::~VertexArray() {
    if (id_) {
        gl_->DeleteVertexArrays(1, &id_);
    }
}

}  // namespace gl
