// What the leaves and planes of a scene look like, for whoever draws its layers.
#pragma once

#include <memory>

#include "csg/solid/placed.h"
#include "csg/solid/scene_change.h"
#include "csg/tree/scene.h"
#include "layers/surface_table.h"

namespace goldfeather {

[[nodiscard]] std::shared_ptr<layers::SurfaceTable> surface_table(const csg::Scene& scene,
                                                                  const csg::solid::Geometry& geometry);

/// Brings a table that nobody else holds up to date with a scene that has been edited in place.
void update(layers::SurfaceTable& table, const csg::Scene& scene, const csg::solid::Geometry& geometry,
            const csg::solid::SceneChange& change);

}  // namespace goldfeather
