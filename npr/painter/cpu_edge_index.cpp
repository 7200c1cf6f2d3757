#include "npr/painter/cpu_edge_index.h"

namespace npr {

EdgeIndex::EdgeIndex(const layers::HostStack& layers, const CpuEdges& edges) : tiles_(layers), edges_(edges) {
    constexpr auto kSide = static_cast<std::uint32_t>(Tiles::kSide);
    for (const std::vector<CpuEdge>& tile : edges) {
        if (tile.empty()) {
            blocks_.push_back(kEmpty);
            continue;
        }
        blocks_.push_back(static_cast<std::uint32_t>(starts_.size()));
        // The tile's edges are in the order of its pixels.
        std::uint32_t edge = 0;
        for (std::uint32_t pixel = 0; pixel <= kSide * kSide; ++pixel) {
            const auto before = [&](const CpuEdge& e) {
                const auto in_tile = glm::uvec2(e.lower) % kSide;
                return in_tile.y * kSide + in_tile.x < pixel;
            };
            while (edge < tile.size() && before(tile[edge])) {
                ++edge;
            }
            starts_.push_back(edge);
        }
    }
}

}  // namespace npr
