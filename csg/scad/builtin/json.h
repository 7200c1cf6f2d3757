// JSON as values of the language.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "csg/scad/value/value.h"

namespace csg::scad {

/// What is wrong with a JSON text, and where: "line 3, column 5: …".
struct JsonError {
    std::string text;
};

/// Objects have their keys in alphabetical order, as in OpenSCAD; of equal keys the last counts. null is undef.
[[nodiscard]] std::variant<Value, JsonError> parse_json(std::string_view text);

}  // namespace csg::scad
