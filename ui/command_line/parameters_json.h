// Customizer parameters as JSON, in OpenSCAD's format.
#pragma once

#include <string>

#include "csg/scad/syntax/ast.h"

namespace ui {

/// The text of a .param file; `title` is the file's name without its suffix.
[[nodiscard]] std::string parameters_json(const csg::scad::Program& program, const std::string& title);

}  // namespace ui
