// Edges found again by the place where a line is looked for.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "npr/painter/cpu_edges.h"
#include "npr/painter/cpu_tiles.h"

namespace npr {

/// For painters that read lines at other places than the pixel they paint (npr/painter/cpu_ink.h spreads them for the
/// others).
class EdgeIndex {
  public:
    /// Both must outlive the object.
    EdgeIndex(const layers::HostStack& layers, const CpuEdges& edges);

    /// The edges on the two links that start at a pixel, which must be in the picture.
    [[nodiscard]] std::span<const CpuEdge> at(glm::ivec2 lower) const {
        const int tile = tiles_.tile_of(lower);
        const std::uint32_t block = blocks_[static_cast<std::size_t>(tile)];
        if (block == kEmpty) {
            return {};
        }
        const glm::ivec2 in_tile = lower % Tiles::kSide;
        const std::uint32_t* first = &starts_[block + static_cast<std::size_t>(in_tile.y * Tiles::kSide + in_tile.x)];
        return std::span(edges_[static_cast<std::size_t>(tile)]).subspan(first[0], first[1] - first[0]);
    }

    [[nodiscard]] const CpuEdges& edges() const { return edges_; }

  private:
    static constexpr std::uint32_t kEmpty = ~0U;

    Tiles tiles_;
    const CpuEdges& edges_;
    std::vector<std::uint32_t> blocks_;  ///< By tile: where its starts begin; kEmpty where it has no edges.
    std::vector<std::uint32_t> starts_;  ///< By pixel of those tiles: where its edges begin among the tile's.
};

}  // namespace npr
