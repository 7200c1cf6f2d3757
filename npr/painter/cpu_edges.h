// The edges of all layers, found without OpenGL (npr/edges/edge_map.h does it with).
#pragma once

#include <cstdint>
#include <vector>

#include "npr/edges/edge_parameters.h"
#include "npr/painter/cpu_frame.h"

namespace npr {

/// An edge meets a link between the samples of two neighboring pixels.
struct CpuEdge {
    glm::ivec2 lower{0};     ///< The link's lower or left pixel.
    glm::vec2 at{0};         ///< Where, counted in samples: pixel (x, y) has its sample at (x, y), whatever the jitter.
    glm::vec2 across{0};     ///< Unit vector across the edge, either way.
    std::uint8_t axis = 0;   ///< 0: the link goes to the right, 1: up.
    std::uint8_t layer = 0;  ///< The last of layers::kLayersApart is that of all deeper ones, too.
    bool profile = false;
    float thickness = 1;  ///< See npr/edges/edge_point.glsl.
    glm::uvec2 facts{0};  ///< As npr/edges/line_facts.glsl packs them, where they were asked for.
};

/// By the tile (layers::HostStack) of the link's lower pixel, in an order that does not depend on threads.
using CpuEdges = std::vector<std::vector<CpuEdge>>;

[[nodiscard]] CpuEdges find_edges(const CpuFrame& frame, const EdgeSettings& settings);

}  // namespace npr
