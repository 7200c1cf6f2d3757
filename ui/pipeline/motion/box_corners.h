// The corners of a box, and how far they are led.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>

#include "csg/tree/box.h"

namespace ui {

/// All eight, of a box that is not empty.
[[nodiscard]] inline std::array<glm::dvec3, 8> corners_of(const csg::Box& box) {
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        corners[i] = {(i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                      (i & 4) != 0 ? box.hi.z : box.lo.z};
    }
    return corners;
}

/// The largest distance between where two matrices put a corner; 0 of an empty box.
[[nodiscard]] inline double farthest_apart(const csg::Box& box, const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0;
    if (!box.empty()) {
        for (const glm::dvec3& corner : corners_of(box)) {
            most = std::max(
                most, glm::distance(glm::dvec3(a * glm::dvec4(corner, 1)), glm::dvec3(b * glm::dvec4(corner, 1))));
        }
    }
    return most;
}

}  // namespace ui
