// How large parts are.
#pragma once

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace goldfeather {

struct PartExtent {
    glm::dvec3 center{0};  ///< World coordinates.
    double radius = 0;     ///< 0 where nothing is left of the part.
};

/// The center of the part's box (of unions, intersections and first operands of differences), and the distance from
/// there to the farthest corner of a mesh that is not subtracted, as far as it lies in the box.
[[nodiscard]] PartExtent extent_of(const csg::Part& part, const csg::Scene& scene,
                                   const csg::solid::Geometry& geometry);

}  // namespace goldfeather
