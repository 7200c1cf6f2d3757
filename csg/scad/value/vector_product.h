// Products of lists: of vectors and matrices.
#pragma once

#include <string>

#include "csg/scad/value/value.h"

namespace csg::scad {

/// Vector or matrix times vector or matrix, both lists; what their first elements are says which is meant. Undef where
/// they do not fit, and `problem` is set to OpenSCAD's warning.
[[nodiscard]] Value multiply_vectors(const Value& a, const Value& b, std::string& problem);

}  // namespace csg::scad
