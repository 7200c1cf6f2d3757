// Leaves and mesh-making operations as OpenSCAD's .csg output prints them.
#pragma once

#include <string>

#include "csg/tree/mesh_operation.h"

namespace csg::scad {

/// "cube(size = [1, 1, 1], center = false)"
[[nodiscard]] std::string leaf_text(const LeafShape& shape);

/// "linear_extrude(height = 10, …)", without the children.
[[nodiscard]] std::string mesh_text(const MeshOperation& operation);

}  // namespace csg::scad
