#include "goldfeather/layer_stack.h"

#include "goldfeather/surface_rows.h"

namespace goldfeather {
namespace {

/// Makes layers from `layer` on empty.
void clear_from(const gl::Functions& gl, const LayerStack& stack, int layer) {
    const float none = 0;
    const glm::uvec2 no_surface(kNoSurface, 0);
    const int count = stack.layers - layer;
    gl.ClearTexSubImage(stack.depth.id(), 0, 0, 0, layer, stack.size.x, stack.size.y, count, GL_RED, GL_FLOAT, &none);
    gl.ClearTexSubImage(stack.surface.id(), 0, 0, 0, layer, stack.size.x, stack.size.y, count, GL_RG_INTEGER,
                        GL_UNSIGNED_INT, &no_surface);
}

}  // namespace

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

void grow(const gl::Functions& gl, LayerStack& stack, int layers) {
    gl::Texture depth = gl::Texture::make_2d_array(gl, GL_R32F, stack.size, layers);
    gl::Texture surface = gl::Texture::make_2d_array(gl, GL_RG32UI, stack.size, layers);
    const int had = stack.layers;
    if (had > 0) {
        gl.CopyImageSubData(stack.depth.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, depth.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0,
                            0, stack.size.x, stack.size.y, had);
        gl.CopyImageSubData(stack.surface.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, surface.id(), GL_TEXTURE_2D_ARRAY, 0,
                            0, 0, 0, stack.size.x, stack.size.y, had);
    }
    stack.depth = std::move(depth);
    stack.surface = std::move(surface);
    stack.layers = layers;
    clear_from(gl, stack, had);
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
