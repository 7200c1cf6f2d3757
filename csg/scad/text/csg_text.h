// The evaluated tree as text: the .csg output, in OpenSCAD's form.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "csg/tree/tree.h"

namespace csg::scad {

/// What OpenSCAD's `-o x.csg` prints: one line a leaf, four-by-four matrices, tabs for depth. Readable as a .scad file.
/// `sink` is given it piece by piece, for as texts go a tree's can be a thousand times the tree.
void write_csg(const Tree& tree, const std::function<void(std::string_view)>& sink);

/// All of it.
[[nodiscard]] std::string csg_text(const Tree& tree);

}  // namespace csg::scad
