#include "goldfeather/leaf_buffers.h"

namespace goldfeather {

LeafBuffers::LeafBuffers(const gl::Functions& gl, const csg::solid::Geometry& geometry,
                         const glm::dvec3& local_centre)
    : planes_(geometry.planes.planes()), vertices_(gl), triangle_planes_(gl), plane_depths_(gl) {
    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> planes;
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        Range range{static_cast<std::uint32_t>(vertices.size()), 0};
        for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
            for (int corner = 0; corner < 3; ++corner)
                vertices.emplace_back(leaf.points[leaf.triangles[t][corner]] - local_centre);
            planes.push_back(leaf.planes[t].index);
        }
        range.vertex_count = static_cast<std::uint32_t>(vertices.size()) - range.first_vertex;
        ranges_.push_back(range);
    }
    triangle_count_ = planes.size();
    vertices_.upload<glm::vec3>(vertices);
    triangle_planes_.upload<std::uint32_t>(planes);
    vertex_texels_ = gl::Texture::make_buffer(gl, GL_RGB32F, vertices_);
    plane_texels_ = gl::Texture::make_buffer(gl, GL_R32UI, triangle_planes_);
}

void LeafBuffers::bind(const gl::View& view) {
    scratch_.clear();
    for (const csg::solid::Plane& plane : planes_) {
        const gl::View::PlaneDepth d = view.plane_depth(plane.normal, plane.offset);
        scratch_.emplace_back(d.a, d.b, d.c, d.edge_on ? 1.0F : 0.0F);
    }
    plane_depths_.upload<glm::vec4>(scratch_, GL_STREAM_DRAW);
    vertex_texels_.bind(8);
    plane_texels_.bind(9);
    plane_depths_.bind(GL_SHADER_STORAGE_BUFFER, 8);
}

}  // namespace goldfeather
