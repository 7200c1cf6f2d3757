// What a program asks of fonts and drawings (csg/scad/builtin/measures.h), answered by csg/solid.
#pragma once

#include <memory>

#include "csg/scad/builtin/measures.h"

namespace ui {

/// Fonts and drawings are read when they are first asked for, and kept.
[[nodiscard]] std::shared_ptr<csg::scad::Measures> make_measures();

}  // namespace ui
