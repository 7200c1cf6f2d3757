// Where doubles become floats: coordinates about the middle of a scene.
#pragma once

#include "csg/solid/placed.h"

namespace goldfeather {

struct LocalFrame {
    glm::dvec3 center{0.0};  ///< World coordinates of the local origin.
    double diagonal = 1;     ///< Of the scene's box.
};

[[nodiscard]] inline LocalFrame local_frame(const csg::solid::Geometry& geometry) {
    return geometry.box.empty() ? LocalFrame{}
                                : LocalFrame{geometry.center.value_or(geometry.box.center()), geometry.box.diagonal()};
}

}  // namespace goldfeather
