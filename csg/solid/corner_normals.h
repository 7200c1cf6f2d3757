// Normals of the smooth surfaces that triangles stand for.
#pragma once

#include <array>
#include <vector>

#include "csg/solid/placed.h"

namespace csg::solid {

/// By corner of a triangle: a unit vector outwards, or zero at the tip of a cone, where there is none.
using CornerNormals = std::array<glm::dvec3, 3>;

/// By triangle of a leaf, in the world: at each corner the mean of the triangles of its smooth surface there
/// (smooth_groups.h), weighted by their angles, so that it does not depend on how polygons are divided. Between the
/// corners they are to be mixed linearly (Phong 1975). Empty where no triangle of the leaf is curved; of flat surfaces
/// the corners are zero.
[[nodiscard]] std::vector<CornerNormals> corner_normals(const PlacedLeaf& leaf);

}  // namespace csg::solid
