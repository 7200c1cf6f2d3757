// Points on triangles, so that none of a triangle's points is far from one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "csg/tree/box.h"

namespace ui {

/// Every point of a face is so many spacings from a sample at most: the diagonal of a cell.
inline constexpr double kSampleReach = 1.4142135623730951;

/// Of the triangle inside the box, as triangles; in the triangle's order.
void clip(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const csg::Box& box,
          std::vector<glm::dvec3>& corners);

/// Appends points of the triangle: cut into cells of `spacing` at most along its longest side and across, one point of
/// each; so at least one. They are off the middle by a share that depends on `seed` only, so that rows do not meet
/// edges that lie on round numbers.
void sample_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double spacing, std::uint32_t seed,
                     std::vector<glm::dvec3>& points);

}  // namespace ui
