// The camera of a picture: what the user and the file say, and what is left to the model's size.
#pragma once

#include <optional>

#include "base/camera.h"
#include "csg/scad/scad.h"
#include "csg/tree/box.h"

namespace ui {

struct CameraRequest {
    std::optional<base::Camera> camera;  ///< Wins over the file's $vp… variables.
    base::Projection projection = base::Projection::Perspective;
    bool view_all = false;
    bool autocenter = false;
    /// Shares of the picture at each side that stay empty: all is brought into view as near as that leaves.
    std::optional<double> margin{};
    double aspect = 1;  ///< Width of the picture by its height.
};

/// Whether the choice depends on the box.
[[nodiscard]] bool needs_box(const CameraRequest& request, const csg::scad::ViewSettings& file);

/// OpenSCAD's rules: a camera that is given stays as it is; else the file's $vpt, $vpr, $vpd and $vpf count, and where
/// there is none of these, all of `box` is brought into view. `view_all` and `autocenter` apply in any case.
[[nodiscard]] base::Camera choose_camera(const CameraRequest& request, const csg::scad::ViewSettings& file,
                                         const csg::Box& box);

/// What a program reads of the camera in $vpt, $vpr, $vpd and $vpf. Angles below 0 are turned up by 360 degrees, as in
/// OpenSCAD.
[[nodiscard]] csg::scad::View scad_view(const base::Camera& camera);

}  // namespace ui
