// OpenSCAD's marks in space, drawn into a picture: axes, their scales, where the camera looks, and edges of faces.
#pragma once

#include "base/camera.h"
#include "base/image.h"
#include "csg/solid/placed.h"
#include "layers/host_stack.h"

namespace ui {

struct ViewMarks {
    bool axes = false;
    bool scales = false;  ///< Ticks and numbers of the axes; not without these.
    bool crosshairs = false;
    bool edges = false;
    bool grid = false;     ///< Of the plane z = 0.
    bool centers = false;  ///< Not of draw_view_marks: ui/pipeline/picture/center_lines.h.
    [[nodiscard]] bool any() const { return axes || crosshairs || edges || grid; }
    bool operator==(const ViewMarks&) const = default;
};

struct MarkColors {
    glm::vec3 axes{0.0F}, crosshairs{0.5F, 0.0F, 0.0F};  ///< sRGB.
};

/// Lines one pixel wide without antialiasing, hidden by what lies before them. Axes are as long as the eye is far from
/// where it looks, their negative halves dashed. Edges are those of the shapes that the model is made of, where they
/// lie in what is seen: half as dark as that. A grid has a line for each small step of the scales, and is seen through.
/// `view`: of the image; `first`: the first layer of the model in that view, or no layer.
void draw_view_marks(base::Image& image, const ViewMarks& marks, const MarkColors& colors, const base::View& view,
                     const csg::solid::Geometry& geometry, const layers::HostStack& first);

}  // namespace ui
