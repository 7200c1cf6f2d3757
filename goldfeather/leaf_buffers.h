// The leaves of a scene in GPU buffers, projected once a view and drawn by every geometry pass.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/solid/scene_change.h"
#include "gl/program.h"
#include "goldfeather/local_frame.h"

namespace goldfeather {

/// Bytes that a shader can reach in one storage block of this OpenGL; what lies behind them is lost without an error.
[[nodiscard]] std::size_t most_bytes_of_a_block(const gl::Functions& gl);

/// Triangles of all leaves, leaf after leaf, three vertices each, in local coordinates (local_frame; doubles become
/// floats here and nowhere else).
class LeafBuffers {
  public:
    /// Why a scene cannot be held: it has more triangles than a storage block has room for. Empty where it can.
    [[nodiscard]] static std::string obstacle(const gl::Functions& gl, const csg::solid::Geometry& geometry);

    /// `geometry` must outlive it. Throws EngineObstacle where there is an obstacle.
    LeafBuffers(const gl::Functions& gl, const csg::solid::Geometry& geometry);

    /// Brings the buffers up to date with the geometry after a change that is none of structure: uploads the leaves
    /// that have changed, unless one has more triangles than it ever had. Throws
    /// EngineObstacle where there is an obstacle.
    void update(const csg::solid::SceneChange& change);

    struct Range {
        std::uint32_t first_vertex = 0;
        std::uint32_t vertex_count = 0;
    };
    [[nodiscard]] const std::vector<Range>& ranges() const { return ranges_; }  ///< By LeafId.
    [[nodiscard]] const LocalFrame& frame() const { return frame_; }
    [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }

    /// Computes the depth functions of all planes (in double precision) and projects all triangles for `view` with
    /// `prepare` (goldfeather/prepare.comp); gl/view.glsl's block must be bound. Uses storage blocks 2 to 6. Throws
    /// base::Stopped where `stop` asked for it.
    void project(const base::View& view, const gl::Program& prepare, const std::stop_token& stop = {});

    /// Binds the rows of the projected triangles to storage block 8; goldfeather/leaf.vert's attribute 1 comes from
    /// `positions()`.
    void bind() const { triangles_.bind(GL_SHADER_STORAGE_BUFFER, 8); }
    [[nodiscard]] const gl::Buffer& positions() const { return positions_; }
    /// Describes attribute 1 to a vertex array: it is read from vertex buffer binding 1.
    static void describe_positions(const gl::Functions& gl, const gl::VertexArray& array);

  private:
    void upload();
    void write(csg::LeafId id);
    void write_planes(csg::LeafId id);

    const gl::Functions& gl_;
    const csg::solid::Geometry& geometry_;
    LocalFrame frame_;
    std::vector<Range> ranges_;
    std::vector<std::uint32_t> room_;  ///< By LeafId: for so many vertices, the most that it has had.
    std::size_t triangle_count_ = 0;
    gl::Buffer vertices_, triangle_ids_, plane_depths_, positions_, triangles_;
    std::vector<glm::vec4> scratch_;
};

}  // namespace goldfeather
