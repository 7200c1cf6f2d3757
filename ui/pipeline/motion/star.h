// A star with spikes to all sides: something hits something.
#pragma once

#include <glm/glm.hpp>

#include "csg/tree/leaf_shape.h"

namespace ui {

/// From every side a star: of the 26 directions to the neighbors in a grid, those along the axes and to the corners
/// have spikes as long as the radius, those to edges shorter ones.
[[nodiscard]] csg::Polyhedron star(const glm::dvec3& middle, double radius);

}  // namespace ui
