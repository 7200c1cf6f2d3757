// The lines about flat models, as OpenGL draws them.
#pragma once

#include "base/camera.h"
#include "base/image.h"
#include "csg/solid/outline.h"

namespace ui {

/// Draws the outline, which lies in the plane z = 0, into a picture taken with `camera`: lines two pixels wide without
/// antialiasing, wherever they are, as OpenSCAD's render has them. So what is thinner than a pixel is seen, too.
/// OpenGL 4.6, 14.5.2.1: along its longer axis a line covers the pixels whose centers lie between its ends, and as many
/// across as it is wide.
void draw_flat_lines(base::Image& image, const csg::solid::Outline& outline, const base::Camera& camera,
                     const glm::vec3& color);

}  // namespace ui
