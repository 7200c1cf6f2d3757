// What the nodes of a tree make: solids, or outlines in the plane.
#pragma once

#include <vector>

#include "csg/tree/tree.h"

namespace csg {

enum class Dimension : std::uint8_t { None, Flat, Solid };

/// By node. A node that combines is what the first of its children is that makes anything, as in OpenSCAD; `%`
/// children do not count. None for what makes nothing.
[[nodiscard]] std::vector<Dimension> dimensions(const Tree& tree);

}  // namespace csg
