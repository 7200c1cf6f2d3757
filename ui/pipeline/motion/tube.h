// Lines that are solids: tubes and arrows along curves.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "csg/tree/leaf_shape.h"

namespace ui {

/// A point of a curve with the radius of the tube there; points may repeat, with another radius.
struct TubePoint {
    glm::dvec3 at{0.0};
    double radius = 0;
};

/// A closed tube of twelve sides around the curve, its ends flat; where the radius is 0 it ends in a point. It does not
/// twist (rotation-minimizing frames). Empty of fewer than two different points.
[[nodiscard]] csg::Polyhedron tube(std::span<const TubePoint> curve);

/// A tube of that radius that ends in a head 3 times as wide and 7 radii long, or all of it where it is shorter.
[[nodiscard]] csg::Polyhedron arrow(std::span<const glm::dvec3> curve, double radius);

/// The curve in pieces of length `dash` with gaps of `gap` between them (world units); the last piece is whole.
[[nodiscard]] std::vector<std::vector<glm::dvec3>> dashes(std::span<const glm::dvec3> curve, double dash, double gap);

[[nodiscard]] double length_of(std::span<const glm::dvec3> curve);

}  // namespace ui
