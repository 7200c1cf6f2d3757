// Where parts are to be seen in a picture: the points that labels' lines lead to.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/camera.h"
#include "csg/tree/scene.h"
#include "layers/host_stack.h"
#include "ui/pipeline/model.h"

namespace ui {

struct PartAnchor {
    glm::ivec2 pixel{0};      ///< From the lower left corner.
    glm::dvec3 point{0.0};    ///< World coordinates: on the surface, behind the pixel's middle.
    int layer = 0;            ///< Of the surface; 0: nothing is before it.
    std::int32_t inside = 0;  ///< Pixels from there to the nearest that does not show the part in that layer.
};

/// Of each group of parts (by part: its group, or kNoGroup), the pixel farthest from all that do not show it, nearest
/// to the middle of what is seen of it; in the first layer that shows any of it. None where no layer does.
inline constexpr std::uint32_t kNoGroup = ~std::uint32_t{0};
[[nodiscard]] std::vector<std::optional<PartAnchor>> part_anchors(const Model& model, const base::View& view,
                                                                  const layers::HostStack& stack,
                                                                  std::span<const std::uint32_t> group_of_part,
                                                                  std::size_t groups);

/// The surface's point behind the middle of that pixel; world coordinates.
[[nodiscard]] glm::dvec3 point_behind(const Model& model, const base::View& view, const glm::ivec2& pixel,
                                      const layers::Surface& surface);

}  // namespace ui
