#include "goldfeather/layer_stack.h"

namespace goldfeather {
namespace {

struct LeafRow {
    glm::vec4 color;
    glm::uvec4 part;
};

}  // namespace

std::shared_ptr<const SurfaceTables> SurfaceTables::make(const gl::Functions& gl, const csg::Scene& scene,
                                                         const csg::solid::Geometry& geometry) {
    auto tables = std::make_shared<SurfaceTables>();
    if (!geometry.box.empty()) {
        tables->local_centre = geometry.box.centre();
        tables->diagonal = geometry.box.diagonal();
    }
    std::vector<LeafRow> leaves;
    leaves.reserve(scene.leaves.size());
    for (const csg::LeafInstance& leaf : scene.leaves)
        leaves.push_back({{leaf.color.r, leaf.color.g, leaf.color.b, leaf.color.a},
                          {leaf.part, static_cast<std::uint32_t>(scene.parts[leaf.part].kind), 0, 0}});
    std::vector<glm::vec4> planes;
    planes.reserve(geometry.planes.planes().size());
    for (const csg::solid::Plane& p : geometry.planes.planes())
        planes.emplace_back(glm::vec3(p.normal),
                            static_cast<float>(p.offset - glm::dot(p.normal, tables->local_centre)));
    tables->leaves = gl::Buffer(gl);
    tables->leaves.upload<LeafRow>(leaves);
    tables->planes = gl::Buffer(gl);
    tables->planes.upload<glm::vec4>(planes);
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
