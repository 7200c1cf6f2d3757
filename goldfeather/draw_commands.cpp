#include "goldfeather/draw_commands.h"

#include <algorithm>

namespace goldfeather {

void DrawCommands::upload(std::span<const DrawCommand> commands, std::size_t piece) {
    buffer_.upload<DrawCommand>(commands, GL_STREAM_DRAW);
    ends_.clear();
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        vertices += std::size_t{commands[i].count} * commands[i].instances;
        if (vertices >= piece || i + 1 == commands.size()) {
            ends_.push_back(static_cast<GLsizei>(i + 1));
            vertices = 0;
        }
    }
}

void DrawCommands::draw(GLenum mode, const std::stop_token& stop) const {
    gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_.id());
    const auto draw_commands = [&](GLsizei first, GLsizei end) {
        const std::size_t offset = static_cast<std::size_t>(first) * sizeof(DrawCommand);
        // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL wants an offset as a pointer.
        gl_.MultiDrawArraysIndirect(mode, reinterpret_cast<const void*>(offset), end - first, 0);
    };
    if (!stop.stop_possible()) {
        if (!ends_.empty()) {
            draw_commands(0, ends_.back());
        }
        return;
    }
    GLsizei first = 0;
    for (const GLsizei end : ends_) {
        if (stop.stop_requested()) {
            return;
        }
        draw_commands(first, end);
        gl_.Finish();
        first = end;
    }
}

void add_triangles(std::vector<DrawCommand>& commands, GLuint first_vertex, GLuint vertex_count, GLuint base_instance) {
    for (GLuint done = 0; done < vertex_count; done += kPieceVertices) {
        commands.push_back({std::min(kPieceVertices, vertex_count - done), 1, first_vertex + done, base_instance});
    }
}

}  // namespace goldfeather
