// Between points of the world and places in the window, by the camera of the picture.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/camera.h"
#include "ui/viewer/layout.h"

namespace ui {

/// Where the point (world coordinates) is seen, in units of the window; nothing where it lies behind the eye.
[[nodiscard]] std::optional<glm::dvec2> place_of(const base::Camera& camera, const Rectangle& picture,
                                                 const glm::dvec3& point);

/// The line of sight through a place in the window, in world coordinates. See base::View::ray.
[[nodiscard]] base::View::Ray sight(const base::Camera& camera, const Rectangle& picture, const glm::dvec2& at);

/// World units of one unit of the window, at that point.
[[nodiscard]] double unit_at(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& point);

/// From `p` to the nearest point of the segment.
[[nodiscard]] double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b);

}  // namespace ui
