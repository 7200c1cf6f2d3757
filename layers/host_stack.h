// The stack of layers in main memory.
#pragma once

#include <cstddef>
#include <deque>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "layers/surface.h"
#include "layers/surface_table.h"

namespace layers {

/// One layer, by pixel; rows from bottom to top.
struct HostLayer {
    std::vector<float> depth;         ///< Reversed depth (base::View); 0: no surface.
    std::vector<glm::uvec2> surface;  ///< layers/surface_ids.glsl
};

/// For each pixel the first `layers` surfaces of the result, in depth order, nearest first: what TextureStack is in
/// textures.
struct HostStack {
    static constexpr int kTileSide = 32;  ///< Pixels; tiles are counted row by row from the lower left.
    glm::ivec2 size{0};
    int layers = 0;  ///< At least 1; `planes` may hold more, from a picture before. The last may be empty everywhere.
    bool complete = false;         ///< True where no pixel has a further layer.
    std::deque<HostLayer> planes;  ///< A deque, so that those there stay where they are while it grows.
    std::vector<int> held;         ///< By tile: layers in which it holds a surface.
    std::vector<int> counts;       ///< By pixel: its surfaces.
    std::shared_ptr<const SurfaceTable> table;

    /// Of that size, and empty; the memory of the planes is kept where it fits.
    void resize(glm::ivec2 to);
    /// Makes planes, empty ones, until there are `count`.
    void reserve(std::size_t count);
    [[nodiscard]] Surface at(int layer, int x, int y) const {
        const HostLayer& plane = planes[static_cast<std::size_t>(layer)];
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
        return decode(plane.depth[pixel], plane.surface[pixel]);
    }
    /// All of them, layer by layer: (layer * height + y) * width + x.
    [[nodiscard]] std::vector<Surface> surfaces() const;
    /// Sets `held` and `counts` by what the planes hold.
    void count();
    /// Sets `held` by `counts`.
    void count_tiles();
};

/// Leaves out the layers, from the last on, in which fewer than this share of the pixels hold a surface (Nienhaus 2005,
/// 5.2); the first one stays.
void leave_out_sparse_layers(HostStack& stack, double minimal_fraction);

}  // namespace layers
