// What the comments of the main file say about its parameters: the groups, descriptions and forms that a customizer
// shows, and that the .ast output repeats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/scad/customizer/parameter_comment.h"
#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// A variable of the main file with a literal value, assigned before the first `{`.
struct Annotation {
    std::optional<std::string> group;  ///< Of the last comment of the form `/* [name] */` on a line above.
    std::string description;           ///< The `//` comment on the line above; may be empty.
    CommentValue form;                 ///< The `//` comment behind it on the same line.
};

/// For each of the assignments of the main file's block; nothing for those that are no parameters.
[[nodiscard]] std::vector<std::optional<Annotation>> annotations(const Program& program);

/// Made of numbers, strings, true, false and undef, and of vectors, ranges and signs of these: no variables.
[[nodiscard]] bool is_literal(const Program& program, ExprId id);

}  // namespace csg::scad
