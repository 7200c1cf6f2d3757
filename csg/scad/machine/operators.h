// What the operators of the language do with values.
#pragma once

#include <string>

#include "csg/scad/syntax/ast.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

/// The value of `a op b` (all binary operators but && and ||, which evaluate their operands themselves). Where the
/// operation is undefined the value is undef and `problem` is set to OpenSCAD's warning.
[[nodiscard]] Value apply_binary(Operator op, const Value& a, const Value& b, std::string& problem);

/// `x % y`: as fmod, quickly where both are whole.
[[nodiscard]] double remainder_of(double x, double y);

/// `!a`, `-a`, `+a`, `~a`.
[[nodiscard]] Value apply_unary(Operator op, const Value& a, std::string& problem);

/// `value[index]`: undef outside; strings by code point, ranges give begin, step, end, objects take a key.
[[nodiscard]] Value element_of(const Value& value, const Value& index);

}  // namespace csg::scad
