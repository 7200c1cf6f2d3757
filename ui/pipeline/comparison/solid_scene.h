// A model's solid as one part, for comparison with its mesh.
#pragma once

#include "ui/pipeline/model.h"

namespace ui {

/// The union of the solid and translucent parts as a scene of one part; `%` and `#` parts are left out. Planes keep
/// their numbers.
struct SolidScene {
    csg::Scene scene;
    csg::solid::Geometry geometry;
};

[[nodiscard]] SolidScene solid_scene(const csg::Scene& scene, const csg::solid::Geometry& geometry);

}  // namespace ui
