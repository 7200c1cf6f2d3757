// What `csgscope measure` tells: distance, angle, radius and diameter of faces, edges and points of a model.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "csg/scad/scad.h"
#include "ui/command_line/measure_options.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/picture/pick.h"

namespace ui {

/// The first `layers` surfaces behind a pixel (0: all).
using PickPixel = std::function<std::vector<PickedSurface>(glm::ivec2 pixel, int layers)>;

/// The text for people, the JSON, or the one value that was asked for. `sources`: of the program that made the model.
/// Throws UsageError where there is nothing at a pixel, no such call, or no such value.
[[nodiscard]] std::string measured_output(const MeasureOptions& options, const Model& model,
                                          const csg::scad::SourceSet& sources, const PickPixel& pick);

}  // namespace ui
