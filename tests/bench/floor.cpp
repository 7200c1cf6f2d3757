#include "tests/bench/floor.h"

#include <array>
#include <vector>

namespace bench {

std::span<const gl::ShaderFile> shader_files();  // Written by csgscope_embed_shaders.

namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
};

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(gl::shader_files());
    library.add(bench::shader_files());
    return library;
}

}  // namespace

Floor::Floor(const gl::Functions& gl, const csg::solid::Geometry& geometry, glm::ivec2 size)
    : gl_(gl),
      center_(geometry.box.empty() ? glm::dvec3(0.0) : geometry.box.center()),
      diagonal_(geometry.box.diagonal()),
      program_(gl, shaders(), {"tests/bench/floor.vert", "tests/bench/floor.frag"}),
      array_(gl),
      vertices_(gl),
      view_block_(gl),
      color_(gl::Texture::make_2d(gl, GL_RGBA8, size)),
      depth_(gl::Texture::make_2d(gl, GL_DEPTH_COMPONENT32F, size)),
      target_(gl) {
    std::vector<Vertex> vertices;
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
            const glm::vec3 normal = geometry.planes.planes()[leaf.planes[t].index].normal;
            for (int corner = 0; corner < 3; ++corner) {
                vertices.push_back({leaf.points[leaf.triangles[t][corner]] - center_, normal});
            }
        }
    }
    count_ = static_cast<GLsizei>(vertices.size());
    vertices_.upload<Vertex>(vertices);
    gl.VertexArrayVertexBuffer(array_.id(), 0, vertices_.id(), 0, sizeof(Vertex));
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        gl.EnableVertexArrayAttrib(array_.id(), attribute);
        gl.VertexArrayAttribFormat(array_.id(), attribute, 3, GL_FLOAT, GL_FALSE,
                                   attribute * static_cast<GLuint>(sizeof(glm::vec3)));
        gl.VertexArrayAttribBinding(array_.id(), attribute, 0);
    }
    target_.attach({&color_}, &depth_);
}

void Floor::draw(const base::View& view) {
    view_block_.update(view, center_, diagonal_);
    view_block_.bind();
    target_.bind();
    gl_.Viewport(0, 0, view.size().x, view.size().y);
    const std::array<float, 4> background{1, 1, 0.9F, 1};
    const float far = 0;
    gl_.DepthMask(GL_TRUE);
    gl_.ClearNamedFramebufferfv(target_.id(), GL_COLOR, 0, background.data());
    gl_.ClearNamedFramebufferfv(target_.id(), GL_DEPTH, 0, &far);
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.Disable(GL_BLEND);
    program_.use();
    array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, count_);
    gl_.Finish();
}

}  // namespace bench
