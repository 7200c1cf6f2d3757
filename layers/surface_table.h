// What the leaves and planes of a stack of layers stand for, in main memory.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "layers/smooth_facets.h"
#include "layers/surface.h"

namespace layers {

enum class PartKind : std::uint32_t {
    Solid = SurfaceCode().kPartSolid,
    Translucent = SurfaceCode().kPartTranslucent,
    Background = SurfaceCode().kPartBackground,
    Highlight = SurfaceCode().kPartHighlight,
};

/// In the layout of the storage blocks of layers/layer_stack.glsl, under the same names.
struct LeafRow {
    glm::vec4 color{0};  ///< Straight alpha; below 0: not given.
    glm::uvec4 part{0};  ///< Part, its PartKind, hatching (csg::LeafInstance), 1 where its groups are estimated | axis.
};

/// A part, by its id.
struct PartLook {
    std::string name;
    PartKind kind = PartKind::Solid;
    glm::vec4 color{-1, -1, -1, 1};  ///< Of its material: straight alpha; red < 0: not given.
    glm::vec3 center{0};             ///< Of the box of its leaves, from local_center.
    float radius = 0;                ///< To the corner of a leaf's mesh that is farthest from the center.
    std::uint32_t rank = 0;          ///< Of parts whose faces coincide the lowest one's is seen.
};

struct SurfaceTable {
    std::vector<PartLook> parts;
    std::vector<LeafRow> leaves;    ///< By leaf.
    std::vector<glm::vec4> planes;  ///< By plane: normal in world coordinates, offset from local_center.
    /// Of planes and leaves: smooth surfaces (layers/smooth_groups.glsl).
    std::vector<std::uint32_t> groups;
    SmoothFacets smooth;           ///< Where they were asked for.
    glm::dvec3 local_center{0.0};  ///< World coordinates.
    double diagonal = 1;           ///< Of the scene's box.
};

}  // namespace layers
