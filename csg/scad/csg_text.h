// The evaluated tree as text: the .csg output, in OpenSCAD's form.
#pragma once

#include <string>

#include "csg/tree/tree.h"

namespace csg::scad {

/// What OpenSCAD's `-o x.csg` prints: one line a leaf, four-by-four matrices, tabs for depth. Readable as a .scad file.
[[nodiscard]] std::string csg_text(const Tree& tree);

}  // namespace csg::scad
