// Nodes as OpenSCAD's .csg output prints them.
#pragma once

#include <string>

#include "csg/tree/tree.h"

namespace csg::scad {

/// Appends "cube(size = [1, 1, 1], center = false)", "group()", "linear_extrude(height = 10, …)": without the children.
void append_node_text(const Tree& tree, NodeId id, std::string& out);

}  // namespace csg::scad
