// A plane across the view, on which things are as large as in the picture.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"

namespace ui {

/// Parallel to the picture, at a distance from the eye's plane (perspective: above 0). Pixels are counted from the
/// picture's lower left corner, as in base::View.
class ScreenPlane {
  public:
    ScreenPlane(const base::View& view, double distance);

    [[nodiscard]] double distance() const { return distance_; }
    /// World units.
    [[nodiscard]] double pixel() const { return pixel_; }
    [[nodiscard]] glm::dvec3 at(const glm::dvec2& pixel) const { return origin_ + pixel.x * x_ + pixel.y * y_; }
    /// Leads x and y, in pixels, to the plane from the pixel `origin` on, and z towards the eye.
    [[nodiscard]] glm::dmat4 to_world(const glm::dvec2& origin) const;

  private:
    double distance_, pixel_;
    glm::dvec3 origin_, x_, y_;  ///< World coordinates: of the pixel (0, 0), and of steps by one pixel.
};

/// Where a point of the world is in the picture, and how far from the eye's plane.
struct SeenAt {
    glm::dvec2 pixel{0.0};
    double distance = 0;
};
[[nodiscard]] SeenAt seen_at(const base::View& view, const glm::dvec3& point);

}  // namespace ui
