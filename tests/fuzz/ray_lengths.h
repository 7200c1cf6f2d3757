// How far parallel rays run inside a model, or a mesh: from triangles and winding numbers alone.
#pragma once

#include <vector>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace fuzz {

/// A ray straight down.
struct RayLength {
    double length = 0;
    double slopes =
        0;  ///< Sum over all surfaces met of 1 / |z of the normal|: what an error of a face does to the length.
    double nearest = 0;  ///< Distance of the ray from the nearest edge of a leaf, seen from above, or less.
};

/// Along rays at the points of the plane: where the first part's expression holds, leaves by their winding numbers.
/// Leaves are taken from their solids and matrices, not from what else `geometry` has made of them.
[[nodiscard]] std::vector<RayLength> lengths_inside(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                                                    const std::vector<glm::dvec2>& rays);

/// The same of a closed mesh with no winding numbers but 0 and 1; `nearest` is not filled.
[[nodiscard]] std::vector<RayLength> lengths_inside(const csg::reference::Mesh& mesh,
                                                    const std::vector<glm::dvec2>& rays);

}  // namespace fuzz
