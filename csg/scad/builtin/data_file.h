// Files that a program names while it runs: drawings, meshes, pictures, JSON.
#pragma once

#include <string>

#include "csg/scad/machine/evaluator.h"

namespace csg::scad {

/// The file beside the one whose text, at `where`, names it, or (as of old, with a message) beside the main file. The
/// path is empty where the name is.
[[nodiscard]] FileStamp find_data_file(Evaluator& evaluator, const SourceRange& where, const std::string& name);

}  // namespace csg::scad
