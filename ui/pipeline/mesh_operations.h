// What csg/solid asks of exact booleans, answered by csg/reference.
#pragma once

#include <memory>

#include "csg/solid/mesh_operations.h"

namespace ui {

/// hull(), minkowski() and booleans below operations that need a mesh. Roofs have no answer.
[[nodiscard]] std::shared_ptr<const csg::solid::MeshOperations> mesh_operations();

}  // namespace ui
