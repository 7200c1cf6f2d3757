// Center lines of what is round, as in drawings (ISO 128-2, type 04.1): long dashes and dots, beyond the outline.
#pragma once

#include <vector>

#include "base/image.h"
#include "npr/picture.h"
#include "ui/pipeline/model.h"

namespace ui {

/// World coordinates.
struct CenterLine {
    glm::dvec3 from{0}, to{0};  ///< The same for spheres, which have no axis.
    double radius = 0;          ///< The largest about it.
    bool operator==(const CenterLine&) const = default;
};

/// The axes of cylinders, cones, rings, circles that are extruded and what is turned about an axis, and the middles of
/// spheres, as the tree has them: as far as the leaf goes, and no farther than the box of its part. What has one axis
/// has one line. None of leaves whose circles are corners of something else (hull, offset, Minkowski sum), and of
/// circles of six sides or fewer.
[[nodiscard]] std::vector<CenterLine> center_lines(const Model& model);

/// Draws them over everything, 2 mm beyond their ends, black on bright pictures and white on dark ones, as wide as
/// hidden lines of `picture`'s style. What is seen along its axis, to within 3 degrees, and spheres have a cross.
void draw_center_lines(base::Image& image, const std::vector<CenterLine>& lines, const npr::Picture& picture,
                       const base::View& view);

}  // namespace ui
