// The floor that every engine is measured against: one plain z-buffer draw of all leaves, nothing subtracted.
#pragma once

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/view_block.h"

namespace bench {

/// A scene's leaves as one vertex buffer.
class Floor {
  public:
    Floor(const gl::Functions& gl, const csg::solid::Geometry& geometry, glm::ivec2 size);

    /// Clears, draws all triangles with a depth test and flat light, and waits.
    void draw(const base::View& view);

  private:
    const gl::Functions& gl_;
    glm::dvec3 center_;
    double diagonal_;
    gl::Program program_;
    gl::VertexArray array_;
    gl::Buffer vertices_;
    gl::ViewBlock view_block_;
    gl::Texture color_, depth_;
    gl::Framebuffer target_;
    GLsizei count_ = 0;
};

}  // namespace bench
