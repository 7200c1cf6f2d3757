// Where doubles become floats: coordinates about the middle of a scene.
#pragma once

#include "csg/solid/placed.h"

namespace goldfeather {

struct LocalFrame {
    glm::dvec3 centre{0.0};  ///< World coordinates of the local origin.
    double diagonal = 1;     ///< Of the scene's box.
};

[[nodiscard]] inline LocalFrame local_frame(const csg::solid::Geometry& geometry) {
    return geometry.box.empty() ? LocalFrame{}
                                : LocalFrame{geometry.centre.value_or(geometry.box.centre()), geometry.box.diagonal()};
}

}  // namespace goldfeather
