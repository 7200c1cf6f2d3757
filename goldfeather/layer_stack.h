// The stack of layers that every engine fills, and that transparency, edges, blueprint, picking and comparison read.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "gl/objects.h"

namespace goldfeather {

/// What leaf ids and plane ids of a stack stand for, on the GPU.
struct SurfaceTables {
    gl::Buffer leaves;  ///< Per leaf: vec4 colour (red < 0: not given), uvec4 (part, kind of the part, 0, 0).
    gl::Buffer planes;  ///< Per plane: vec4 (normal in world coordinates, offset from local_centre).
    glm::dvec3 local_centre{0.0};
    double diagonal = 1;  ///< Of the scene's box.

    static std::shared_ptr<const SurfaceTables> make(const gl::Functions& gl, const csg::Scene& scene,
                                                     const csg::solid::Geometry& geometry);
};

/// "No surface" in LayerStack::surface.x.
inline constexpr std::uint32_t kNoSurface = ~std::uint32_t{0};

/// For each pixel the first `layers` surfaces of the result, in depth order, nearest first. Rows from bottom to top.
struct LayerStack {
    glm::ivec2 size{0};
    int layers = 0;         ///< How many layers the textures hold; at least 1. The last may be empty everywhere.
    bool complete = false;  ///< True where no pixel has a further layer.
    gl::Texture depth;      ///< R32F array: reversed depth (base::View); 0 where there is no surface.
    /// RG32UI array. x: leaf id << 1 | reversed, or kNoSurface; `reversed` where the surface belongs to a subtracted
    /// leaf. y: plane id << 1 | leaving; `leaving` where the ray leaves the result there (a back face of it).
    gl::Texture surface;
    std::shared_ptr<const SurfaceTables> tables;
};

/// Makes room for `layers` layers, more than there are; the new ones are empty.
void grow(const gl::Functions& gl, LayerStack& stack, int layers);

/// One surface of a stack, in main memory.
struct Surface {
    float depth = 0;
    csg::LeafId leaf = 0;
    std::uint32_t plane = 0;
    bool reversed = false;
    bool leaving = false;
    bool operator==(const Surface&) const = default;
};

/// What a texel of LayerStack::depth and one of LayerStack::surface say.
[[nodiscard]] inline Surface decode_surface(float depth, const glm::uvec2& ids) {
    return ids.x == kNoSurface ? Surface{}
                               : Surface{depth, ids.x >> 1, ids.y >> 1, (ids.x & 1U) != 0, (ids.y & 1U) != 0};
}

/// A copy of a stack in main memory: surfaces[(layer * height + y) * width + x], rows from bottom to top.
/// depth 0: no surface.
struct HostLayers {
    glm::ivec2 size{0};
    int layers = 0;
    std::vector<Surface> surfaces;

    [[nodiscard]] const Surface& at(int layer, int x, int y) const {
        return surfaces[(static_cast<std::size_t>(layer) * static_cast<std::size_t>(size.y) +
                         static_cast<std::size_t>(y)) *
                            static_cast<std::size_t>(size.x) +
                        static_cast<std::size_t>(x)];
    }
};

/// Waits for the GPU and copies.
[[nodiscard]] HostLayers read_back(const gl::Functions& gl, const LayerStack& stack);

}  // namespace goldfeather
