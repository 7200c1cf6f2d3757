// Expressions as source text, in OpenSCAD's normal form.
#pragma once

#include <string>

#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// "(x + (y * 2))", "function(x, y = 2) …", as echo() and assert() show it.
[[nodiscard]] std::string expression_text(const Program& program, ExprId id);

}  // namespace csg::scad
