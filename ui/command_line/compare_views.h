// The views of csgscope compare, and what people see of them.
#pragma once

#include "layers/host_stack.h"
#include "ui/command_line/compare_report.h"
#include "ui/pipeline/comparison/errors.h"
#include "ui/pipeline/comparison/solid_scene.h"

namespace ui {

/// Views evenly spread (on a spiral), perspective and orthographic in turn; the first is OpenSCAD's default.
[[nodiscard]] base::Camera spread_camera(int view, int views, const csg::Box& box);

/// White.
[[nodiscard]] base::Image blank_image(glm::ivec2 size);

/// Both solids in the same plain light, and a map of their differences; the title is left to the caller.
[[nodiscard]] ComparedView compared_view(const SolidScene& solid, const csg::reference::Mesh& mesh,
                                         const base::View& view, const layers::HostStack& stack,
                                         const MeshLayers& truth, const Comparison& comparison);

}  // namespace ui
