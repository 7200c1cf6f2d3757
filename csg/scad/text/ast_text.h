// The syntax tree as source text again: the .ast output, in OpenSCAD's normal form.
#pragma once

#include <string>

#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// The main file's unit as OpenSCAD's `-o x.ast` prints it.
[[nodiscard]] std::string ast_text(const Program& program);

}  // namespace csg::scad
