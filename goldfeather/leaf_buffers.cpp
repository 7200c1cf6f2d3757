#include "goldfeather/leaf_buffers.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/stop.h"
#include "goldfeather/engine.h"

namespace goldfeather {
namespace {

/// That are projected at once where it may have to stop in between; a multiple of the shader's groups.
constexpr unsigned kPieceTriangles = 1U << 16;

/// Of a triangle in the largest of the buffers, the projected positions.
constexpr std::size_t kTriangleBytes = 3 * sizeof(glm::vec4);

}  // namespace

std::size_t most_bytes_of_a_block(const gl::Functions& gl) {
    GLint bytes = 0;
    gl.GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);  // Larger ones are clamped to the largest int.
    return static_cast<std::size_t>(std::max(bytes, 0));
}

std::string LeafBuffers::obstacle(const gl::Functions& gl, const csg::solid::Geometry& geometry) {
    std::size_t triangles = 0;
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        triangles += leaf.triangles.size();
    }
    const std::size_t most = most_bytes_of_a_block(gl) / kTriangleBytes;
    return triangles <= most ? ""
                             : fmt::format("its leaves have {} triangles, and this OpenGL takes {}", triangles, most);
}

LeafBuffers::LeafBuffers(const gl::Functions& gl, const csg::solid::Geometry& geometry)
    : gl_(gl),
      geometry_(geometry),
      vertices_(gl),
      triangle_ids_(gl),
      plane_depths_(gl),
      positions_(gl),
      triangles_(gl) {
    upload();
}

void LeafBuffers::upload() {
    if (const std::string reason = obstacle(gl_, geometry_); !reason.empty()) {
        throw EngineObstacle(reason);
    }
    frame_ = local_frame(geometry_);
    room_.resize(geometry_.leaves.size(), 0);
    ranges_.clear();
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec2> ids;
    for (csg::LeafId id = 0; id < geometry_.leaves.size(); ++id) {
        const csg::solid::PlacedLeaf& leaf = geometry_.leaves[id];
        Range range{static_cast<std::uint32_t>(vertices.size()), 0};
        for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
            for (int corner = 0; corner < 3; ++corner) {
                vertices.emplace_back(leaf.points[leaf.triangles[t][corner]] - frame_.center);
            }
            ids.emplace_back(leaf.planes[t].index, id);
        }
        range.vertex_count = static_cast<std::uint32_t>(vertices.size()) - range.first_vertex;
        room_[id] = std::max(room_[id], range.vertex_count);
        vertices.resize(range.first_vertex + room_[id]);
        ids.resize(vertices.size() / 3);
        ranges_.push_back(range);
    }
    triangle_count_ = ids.size();
    vertices_.upload<glm::vec3>(vertices);
    triangle_ids_.upload<glm::uvec2>(ids);
    positions_.reserve(triangle_count_ * kTriangleBytes, GL_DYNAMIC_COPY);
    triangles_.reserve(triangle_count_ * 2 * sizeof(glm::vec4), GL_DYNAMIC_COPY);  // as TriangleRow
}

void LeafBuffers::update(const csg::solid::SceneChange& change) {
    const bool grown = std::any_of(change.leaves.begin(), change.leaves.end(), [&](csg::LeafId id) {
        return 3 * geometry_.leaves[id].triangles.size() > room_[id];
    });
    if (change.center || grown) {
        upload();
        return;
    }
    frame_ = local_frame(geometry_);
    for (const csg::LeafId id : change.leaves) {
        write(id);
    }
    if (change.all_planes) {
        for (csg::LeafId id = 0; id < ranges_.size(); ++id) {
            write_planes(id);
        }
    }
}

void LeafBuffers::write(csg::LeafId id) {
    const csg::solid::PlacedLeaf& leaf = geometry_.leaves[id];
    std::vector<glm::vec3> vertices;
    for (const glm::uvec3& triangle : leaf.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            vertices.emplace_back(leaf.points[triangle[corner]] - frame_.center);
        }
    }
    ranges_[id].vertex_count = static_cast<std::uint32_t>(vertices.size());
    vertices_.write<glm::vec3>(ranges_[id].first_vertex * sizeof(glm::vec3), vertices);
    write_planes(id);
}

void LeafBuffers::write_planes(csg::LeafId id) {
    std::vector<glm::uvec2> ids;
    for (const csg::solid::PlaneRef& plane : geometry_.leaves[id].planes) {
        ids.emplace_back(plane.index, id);
    }
    triangle_ids_.write<glm::uvec2>(ranges_[id].first_vertex / 3 * sizeof(glm::uvec2), ids);
}

void LeafBuffers::project(const base::View& view, const gl::Program& prepare, const std::stop_token& stop) {
    scratch_.clear();
    for (const csg::solid::Plane& plane : geometry_.planes.planes()) {
        const base::View::PlaneDepth d = view.plane_depth(plane.normal, plane.offset);
        scratch_.emplace_back(d.a, d.b, d.c, d.edge_on ? 1.0F : 0.0F);
    }
    plane_depths_.upload<glm::vec4>(scratch_, GL_STREAM_DRAW);
    GLuint binding = 2;
    for (const gl::Buffer* buffer : {&vertices_, &triangle_ids_, &plane_depths_, &positions_, &triangles_}) {
        buffer->bind(GL_SHADER_STORAGE_BUFFER, binding++);
    }
    const auto count = static_cast<unsigned>(triangle_count_);
    prepare.set("triangle_count", count);
    prepare.use();
    const unsigned piece = stop.stop_possible() ? kPieceTriangles : count;
    for (unsigned first = 0; first < count; first += piece) {
        base::end_if_asked(stop);
        prepare.set("first_triangle", first);
        gl_.DispatchCompute((std::min(piece, count - first) + 63) / 64, 1, 1);
        if (stop.stop_possible()) {
            gl_.Finish();
        }
    }
    gl_.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void LeafBuffers::describe_positions(const gl::Functions& gl, const gl::VertexArray& array) {
    gl.EnableVertexArrayAttrib(array.id(), 1);
    gl.VertexArrayAttribFormat(array.id(), 1, 4, GL_FLOAT, GL_FALSE, 0);
    gl.VertexArrayAttribBinding(array.id(), 1, 1);
}

}  // namespace goldfeather
