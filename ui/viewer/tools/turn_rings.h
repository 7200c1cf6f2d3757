// Rings that something is turned by: one about each axis of the world.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "ui/viewer/layout.h"

namespace ui {

/// As they are seen by the camera of the picture, of the same size on the screen from everywhere.
class TurnRings {
  public:
    /// `pivot`: world coordinates; `scale`: of the interface.
    TurnRings(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& pivot, float scale);

    struct Corner {
        glm::dvec2 at;        ///< Window coordinates.
        bool behind = false;  ///< Of the pivot, seen from the eye.
    };
    /// Around that axis, closed; empty where a part of it lies behind the eye.
    [[nodiscard]] std::vector<Corner> ring(std::size_t axis) const;
    /// Of the ring there, or within a few pixels; the parts in front first.
    [[nodiscard]] std::optional<std::size_t> axis_at(const glm::dvec2& at) const;
    /// The angle about the axis, in degrees, at which the line of sight meets its ring's plane; nothing where that is
    /// seen from its edge.
    [[nodiscard]] std::optional<double> angle_at(std::size_t axis, const glm::dvec2& at) const;

  private:
    const base::Camera& camera_;
    Rectangle picture_;
    glm::dvec3 pivot_;
    double radius_, reach_;
};

}  // namespace ui
