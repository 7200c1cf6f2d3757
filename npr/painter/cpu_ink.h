// Lines along edges, tile by tile.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "layers/limits.h"
#include "npr/edges/line_types.h"
#include "npr/painter/cpu_edges.h"
#include "npr/painter/cpu_tiles.h"
#include "npr/shader_frame.h"

namespace npr {

/// How much ink the lines of each layer leave in the pixels of one tile: what npr/edges/lines.glsl gathers pixel by
/// pixel is spread here from edge to edge.
class TileInk {
  public:
    /// `edges` must outlive the object; found with the same settings.
    TileInk(const CpuFrame& frame, const CpuEdges& edges, const LinedSettings& lines)
        : tiles_(frame.layers),
          edges_(edges),
          lines_(lines),
          reach_(static_cast<int>(0.5F * lines.width + 0.5F)),
          ink_(layers::kLayersApart * kPixels) {}

    /// Draws the lines of a tile, and forgets those of the tile before. `rules`: any of the frame.
    void draw(int tile, shader::Frame& rules);

    /// May there be ink in the pixel? It must be in the tile.
    [[nodiscard]] bool near(glm::ivec2 pixel) const {
        return (near_[static_cast<std::size_t>(pixel.y - box_.lo.y)] >> (pixel.x - box_.lo.x) & 1U) != 0;
    }
    [[nodiscard]] float ink(int layer, glm::ivec2 pixel) const {
        return (drawn_ >> layer & 1U) != 0 ? ink_[at(layer, pixel - box_.lo)] : 0.0F;
    }

  private:
    struct Pen {
        float width;  ///< Pixels.
        float strength;
    };
    static constexpr std::size_t kPixels = static_cast<std::size_t>(Tiles::kSide) * Tiles::kSide;
    static std::size_t at(int layer, glm::ivec2 in_tile) {
        return static_cast<std::size_t>(layer) * kPixels +
               static_cast<std::size_t>(in_tile.y * Tiles::kSide + in_tile.x);
    }
    /// Any pixel of the tile.
    [[nodiscard]] bool reaches(const CpuEdge& edge) const {
        return edge.lower.x - reach_ < box_.hi.x && edge.lower.y - reach_ < box_.hi.y &&
               edge.lower.x + reach_ + 2 > box_.lo.x && edge.lower.y + reach_ + 2 > box_.lo.y;
    }
    void spread(const CpuEdge& edge, shader::Frame& rules);
    [[nodiscard]] Pen pen_of(const CpuEdge& edge, shader::Frame& rules) const;

    Tiles tiles_;
    const CpuEdges& edges_;
    LinedSettings lines_;
    int reach_;  ///< A pixel looks so far for links, as in links_near of npr/edges/line_ink.glsl.
    TileBounds box_;
    std::vector<float> ink_;
    std::array<std::uint32_t, Tiles::kSide> near_{};  ///< By row, a bit for each pixel.
    std::uint32_t drawn_ = 0;                         ///< A bit for each layer that has lines in the tile.
};

}  // namespace npr
