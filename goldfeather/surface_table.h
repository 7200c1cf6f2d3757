// What the leaves and planes of a scene look like, for whoever draws its layers.
#pragma once

#include <memory>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "layers/surface_table.h"

namespace goldfeather {

[[nodiscard]] std::shared_ptr<const layers::SurfaceTable> surface_table(const csg::Scene& scene,
                                                                        const csg::solid::Geometry& geometry);

}  // namespace goldfeather
