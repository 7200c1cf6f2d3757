// Many draws at once, in pieces where they may have to stop in between.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "gl/objects.h"

namespace goldfeather {

/// OpenGL's DrawArraysIndirectCommand.
struct DrawCommand {
    GLuint count, instances, first, base_instance;
};

/// Commands in a buffer of the GPU.
class DrawCommands {
  public:
    /// `gl` must outlive the object.
    explicit DrawCommands(const gl::Functions& gl) : gl_(gl), buffer_(gl) {}

    /// A piece ends where it has as many vertices as `piece`, all instances counted; a command is never divided.
    void upload(std::span<const DrawCommand> commands, std::size_t piece);

    /// Draws all of them with the program, the arrays and the target that are bound. Where `stop` can be asked for, the
    /// GPU is waited for after each piece, and what is left is not drawn once it is: the caller is to look and throw.
    void draw(GLenum mode, const std::stop_token& stop) const;

  private:
    const gl::Functions& gl_;
    gl::Buffer buffer_;
    std::vector<GLsizei> ends_;  ///< Of the pieces, counted in commands.
};

/// Triangles as commands of at most kPieceVertices each.
void add_triangles(std::vector<DrawCommand>& commands, GLuint first_vertex, GLuint vertex_count, GLuint base_instance);

/// So many vertices of triangles take a software renderer some milliseconds.
inline constexpr GLuint kPieceVertices = 3 * 16384;

}  // namespace goldfeather
