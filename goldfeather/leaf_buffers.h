// The leaves of a scene in GPU buffers, drawn by every geometry pass.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/placed.h"
#include "gl/camera.h"
#include "gl/objects.h"

namespace goldfeather {

/// Triangles of all leaves, leaf after leaf, three vertices each, in local coordinates (world minus `local_centre`:
/// doubles become floats here and nowhere else).
class LeafBuffers {
  public:
    LeafBuffers(const gl::Functions& gl, const csg::solid::Geometry& geometry, const glm::dvec3& local_centre);

    struct Range {
        std::uint32_t first_vertex = 0;
        std::uint32_t vertex_count = 0;
    };
    [[nodiscard]] const std::vector<Range>& ranges() const { return ranges_; }
    [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }

    /// Computes the depth functions of all planes for `view`, and binds vertices (texture unit 8), planes of
    /// triangles (texture unit 9) and depth functions (storage block 8), for goldfeather/leaf.glsl.
    void bind(const gl::View& view);

  private:
    std::vector<csg::solid::Plane> planes_;
    std::vector<Range> ranges_;
    std::size_t triangle_count_ = 0;
    gl::Buffer vertices_, triangle_planes_, plane_depths_;
    gl::Texture vertex_texels_, plane_texels_;
    std::vector<glm::vec4> scratch_;
};

}  // namespace goldfeather
