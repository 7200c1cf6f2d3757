// Roofs by distance.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/mesh.h"
#include "csg/tree/leaf_shape.h"

namespace csg::reference {

/// The closed roof over a region (outer loops counter-clockwise, holes clockwise, none crossing), from z = 0 up to each
/// point's distance to the nearest point of the outline: a plane over the Voronoi cell of an edge, a cone over that of
/// a corner that points inwards. A cone's rim, which the curved ridges are part of, is divided as a circle through its
/// farthest point by `fineness`. Loops may touch. Throws std::runtime_error where the loops cross, or overlap along
/// an edge, by more than 2^-28 of their size.
[[nodiscard]] Mesh voronoi_roof(std::span<const std::vector<glm::dvec2>> loops, const Fineness& fineness,
                                const std::stop_token& stop = {});

}  // namespace csg::reference
