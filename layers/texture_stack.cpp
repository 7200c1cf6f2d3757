#include "layers/texture_stack.h"

#include <array>

namespace layers {
namespace {

/// Makes layers from `layer` on empty.
void clear_from(const gl::Functions& gl, const TextureStack& stack, int layer) {
    const float none = 0;
    const glm::uvec2 no_surface(kNoSurface, 0);
    const int count = stack.layers - layer;
    gl.ClearTexSubImage(stack.depth.id(), 0, 0, 0, layer, stack.size.x, stack.size.y, count, GL_RED, GL_FLOAT, &none);
    gl.ClearTexSubImage(stack.surface.id(), 0, 0, 0, layer, stack.size.x, stack.size.y, count, GL_RG_INTEGER,
                        GL_UNSIGNED_INT, &no_surface);
}

}  // namespace

SurfaceBuffers::SurfaceBuffers(const gl::Functions& gl, const SurfaceTable& table)
    : parts(table.parts),
      leaves(gl),
      planes(gl),
      groups(gl),
      facet_starts(gl),
      facets(gl),
      local_center(table.local_center),
      diagonal(table.diagonal) {
    leaves.upload<LeafRow>(table.leaves);
    planes.upload<glm::vec4>(table.planes);
    groups.upload<std::uint32_t>(table.groups);
    take(table.smooth);
}

void SurfaceBuffers::take(const SmoothFacets& smooth) {
    knows_facets = !smooth.starts.empty();
    const std::vector<std::uint32_t> none(knows_facets ? 0 : planes.size() / sizeof(glm::vec4) + 1);
    const std::array<SmoothFacet, 1> nothing{};
    facet_starts.upload<std::uint32_t>(knows_facets ? smooth.starts : none);
    facets.upload<SmoothFacet>(smooth.facets.empty() ? std::span<const SmoothFacet>(nothing) : smooth.facets);
}

void SurfaceBuffers::update(const SurfaceTable& table, std::span<const std::uint32_t> changed_planes) {
    diagonal = table.diagonal;
    for (const std::uint32_t plane : changed_planes) {
        planes.write<glm::vec4>(plane * sizeof(glm::vec4), {&table.planes[plane], 1});
    }
    groups.upload<std::uint32_t>(table.groups);
    if (knows_facets || !table.smooth.starts.empty()) {
        take(table.smooth);
    }
}

void grow(const gl::Functions& gl, TextureStack& stack, int layers) {
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

HostStack read_back(const gl::Functions& gl, const TextureStack& stack) {
    HostStack host;
    host.resize(stack.size);
    host.layers = stack.layers;
    host.complete = stack.complete;
    host.reserve(static_cast<std::size_t>(stack.layers));
    const auto bytes = [](const auto& values) { return static_cast<GLsizei>(values.size() * sizeof(values[0])); };
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int layer = 0; layer < stack.layers; ++layer) {
        HostLayer& plane = host.planes[static_cast<std::size_t>(layer)];
        gl.GetTextureSubImage(stack.depth.id(), 0, 0, 0, layer, stack.size.x, stack.size.y, 1, GL_RED, GL_FLOAT,
                              bytes(plane.depth), plane.depth.data());
        gl.GetTextureSubImage(stack.surface.id(), 0, 0, 0, layer, stack.size.x, stack.size.y, 1, GL_RG_INTEGER,
                              GL_UNSIGNED_INT, bytes(plane.surface), plane.surface.data());
    }
    host.count();
    return host;
}

std::vector<float> first_depths(const gl::Functions& gl, const TextureStack& stack) {
    std::vector<float> depths(static_cast<std::size_t>(stack.size.x) * static_cast<std::size_t>(stack.size.y));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.GetTextureSubImage(stack.depth.id(), 0, 0, 0, 0, stack.size.x, stack.size.y, 1, GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(depths.size() * sizeof(float)), depths.data());
    return depths;
}

std::shared_ptr<const HostStack> in_main_memory(const gl::Functions& gl, const Stack& stack) {
    return stack.host ? stack.host : std::make_shared<const HostStack>(read_back(gl, *stack.textures));
}

void bind(const TextureStack& stack) {
    stack.depth.bind(0);
    stack.surface.bind(1);
    stack.table->leaves.bind(GL_SHADER_STORAGE_BUFFER, 0);
    stack.table->planes.bind(GL_SHADER_STORAGE_BUFFER, 1);
    stack.table->groups.bind(GL_SHADER_STORAGE_BUFFER, 10);
    stack.table->facet_starts.bind(GL_SHADER_STORAGE_BUFFER, 12);
    stack.table->facets.bind(GL_SHADER_STORAGE_BUFFER, 13);
}

}  // namespace layers
