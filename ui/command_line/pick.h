// What `csgscope pick` tells.
#pragma once

#include <string>
#include <vector>

#include "csg/scad/scad.h"
#include "ui/command_line/options.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/picture/pick.h"

namespace ui {

struct PickReport {
    const Model& model;
    const csg::scad::SourceSet& sources;  ///< Of the program that made the model.
    glm::ivec2 at, size;                  ///< The pixel, counted from the upper left corner, and the picture.
    base::Camera camera;
    std::vector<PickedSurface> surfaces;  ///< Nearest first.
};

/// For people: a paragraph for each surface.
[[nodiscard]] std::string pick_text(const PickReport& report);

/// {"pixel": …, "size": …, "camera": …, "surfaces": [{"layer": …, "distance": …, "point": …, "leaf": …, "calls": […]}]}
[[nodiscard]] Json pick_json(const PickReport& report);

}  // namespace ui
