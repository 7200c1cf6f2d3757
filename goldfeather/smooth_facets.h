// Triangles that stand for smooth surfaces, for whoever shades them so.
#pragma once

#include "csg/solid/placed.h"
#include "layers/smooth_facets.h"

namespace goldfeather {

/// Those whose corners have other normals than their plane.
[[nodiscard]] layers::SmoothFacets smooth_facets(const csg::solid::Geometry& geometry);

}  // namespace goldfeather
