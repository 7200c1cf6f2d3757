// What leaf ids and plane ids of a stack of layers stand for, in main memory.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace goldfeather {

/// In the layout of the storage blocks of peel/layer_stack.glsl, under the same names.
struct LeafRow {
    glm::vec4 color{0};  ///< Straight alpha; red < 0: not given.
    glm::uvec4 part{0};  ///< Part, its kind (csg::PartKind), 0, 0.
};

struct SurfaceRows {
    std::vector<LeafRow> leaves;    ///< By leaf.
    std::vector<glm::vec4> planes;  ///< By plane: normal in world coordinates, offset from local_centre.
    glm::dvec3 local_centre{0.0};   ///< World coordinates.
    double diagonal = 1;            ///< Of the scene's box.
};

[[nodiscard]] SurfaceRows surface_rows(const csg::Scene& scene, const csg::solid::Geometry& geometry);

}  // namespace goldfeather
