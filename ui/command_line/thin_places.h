// The places that a map of thickness marks, told in words.
#pragma once

#include <string>

#include "csg/scad/scad.h"
#include "ui/pipeline/picture/thickness_map.h"

namespace ui {

/// A line for each: size, point, part, and the calls that made the two faces. `sources`: of the program that made the
/// model.
[[nodiscard]] std::string thin_places_text(const Model& model, const csg::scad::SourceSet& sources,
                                           const ThicknessMap& map);

}  // namespace ui
