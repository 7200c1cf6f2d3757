// Customizer parameters as JSON, and parameter sets: OpenSCAD's formats.
#pragma once

#include <string>
#include <vector>

#include "csg/scad/syntax/ast.h"

namespace ui {

/// The text of a .param file; `title` is the file's name without its suffix.
[[nodiscard]] std::string parameters_json(const csg::scad::Program& program, const std::string& title);

struct ParameterSet {
    std::vector<std::string> definitions;  ///< name=expression, for each parameter that the set gives a fitting value.
    std::string problem;                   ///< Why there are none; a warning, as the file's own values then hold.
};

/// The set `name` of `json`, the text of a file of parameter sets (`path`, for messages).
[[nodiscard]] ParameterSet read_parameter_set(const csg::scad::Program& program, const std::string& json,
                                              const std::string& path, const std::string& name);

}  // namespace ui
