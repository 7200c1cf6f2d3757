// What nodes that make a mesh ask for (csg/solid/mesh_operations.h), answered by csg/reference.
#pragma once

#include <memory>

#include "csg/solid/mesh_operations.h"

namespace ui {

/// Booleans, hull and Minkowski sum in exact arithmetic.
[[nodiscard]] std::shared_ptr<const csg::solid::MeshOperations> exact_operations();

}  // namespace ui
