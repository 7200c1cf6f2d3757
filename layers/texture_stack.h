// The stack of layers in textures.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_file.h"
#include "layers/host_stack.h"
#include "layers/stack.h"
#include "layers/surface_table.h"

namespace layers {

/// SurfaceTable on the GPU.
struct SurfaceBuffers {
    SurfaceBuffers(const gl::Functions& gl, const SurfaceTable& table);
    /// The table, as large as before, has other rows for these planes, and another diagonal.
    void update(const SurfaceTable& table, std::span<const std::uint32_t> changed_planes);
    void take(const SmoothFacets& smooth);

    std::vector<PartLook> parts;
    gl::Buffer leaves;  ///< Of LeafRow.
    gl::Buffer planes;
    gl::Buffer groups;
    gl::Buffer facet_starts, facets;  ///< SmoothFacets; without any they are empty.
    bool knows_facets = false;
    glm::dvec3 local_center;
    double diagonal;
};

/// For each pixel the first `layers` surfaces of the result, in depth order, nearest first. Rows from bottom to top.
struct TextureStack {
    glm::ivec2 size{0};
    int layers = 0;         ///< How many layers the textures hold; at least 1. The last may be empty everywhere.
    bool complete = false;  ///< True where no pixel has a further layer.
    gl::Texture depth;      ///< R32F array: reversed depth (base::View); 0 where there is no surface.
    gl::Texture surface;    ///< RG32UI array: layers/surface_ids.glsl.
    std::shared_ptr<const SurfaceBuffers> table;
};

/// Makes room for `layers` layers, more than there are; the new ones are empty.
void grow(const gl::Functions& gl, TextureStack& stack, int layers);

/// Waits for the GPU and copies all but the table.
[[nodiscard]] HostStack read_back(const gl::Functions& gl, const TextureStack& stack);

/// The same of the depths of the first layer, by pixel.
[[nodiscard]] std::vector<float> first_depths(const gl::Functions& gl, const TextureStack& stack);

/// The stack itself, where it is in main memory, or a copy.
[[nodiscard]] std::shared_ptr<const HostStack> in_main_memory(const gl::Functions& gl, const Stack& stack);

/// Binds `stack` for shaders that include layers/layer_stack.glsl: texture units 0 and 1, storage blocks 0, 1, 10, 12
/// and 13.
void bind(const TextureStack& stack);

/// This folder's shader files.
[[nodiscard]] std::span<const gl::ShaderFile> shader_files();

}  // namespace layers
