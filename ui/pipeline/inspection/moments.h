// Moments of a solid that is put together of square prisms along rays.
#pragma once

#include <glm/glm.hpp>

#include "csg/tree/box.h"

namespace ui {

/// About the origin of what is added.
struct MomentSums {
    double volume = 0, volume_error = 0, area = 0, area_error = 0;
    glm::dvec3 first{0.0};   ///< Of the coordinates.
    glm::dmat3 second{0.0};  ///< Of their products.
    csg::Box box;

    /// A prism of `side` by `side` about the line from `start` on, along `direction` (of length 1, along an axis).
    void add_segment(const glm::dvec3& start, const glm::dvec3& direction, double length, double side);
};

/// Of inertia about the centroid (seen from the same origin), at density 1, the least first.
[[nodiscard]] glm::dvec3 principal_moments(const MomentSums& sums, const glm::dvec3& centroid);

}  // namespace ui
