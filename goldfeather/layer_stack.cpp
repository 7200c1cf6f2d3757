#include "goldfeather/layer_stack.h"

#include "goldfeather/surface_rows.h"

namespace goldfeather {

std::shared_ptr<const SurfaceTables> SurfaceTables::make(const gl::Functions& gl, const csg::Scene& scene,
                                                         const csg::solid::Geometry& geometry) {
    const SurfaceRows rows = surface_rows(scene, geometry);
    auto tables = std::make_shared<SurfaceTables>();
    tables->local_centre = rows.local_centre;
    tables->diagonal = rows.diagonal;
    tables->leaves = gl::Buffer(gl);
    tables->leaves.upload<LeafRow>(rows.leaves);
    tables->planes = gl::Buffer(gl);
    tables->planes.upload<glm::vec4>(rows.planes);
    return tables;
}

HostLayers read_back(const gl::Functions& gl, const LayerStack& stack) {
    HostLayers host{stack.size, stack.layers, {}};
    const std::size_t count = static_cast<std::size_t>(stack.size.x) * static_cast<std::size_t>(stack.size.y) *
                              static_cast<std::size_t>(stack.layers);
    std::vector<float> depth(count);
    std::vector<glm::uvec2> surface(count);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.GetTextureSubImage(stack.depth.id(), 0, 0, 0, 0, stack.size.x, stack.size.y, stack.layers, GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(count * sizeof(float)), depth.data());
    gl.GetTextureSubImage(stack.surface.id(), 0, 0, 0, 0, stack.size.x, stack.size.y, stack.layers, GL_RG_INTEGER,
                          GL_UNSIGNED_INT, static_cast<GLsizei>(count * sizeof(glm::uvec2)), surface.data());
    host.surfaces.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        host.surfaces.push_back(decode_surface(depth[i], surface[i]));
    return host;
}

}  // namespace goldfeather
