// Booleans of plain meshes, for nodes that make a mesh.
#pragma once

#include <span>

#include "csg/reference/boolean.h"

namespace csg::reference {

/// Meshes as the leaves of a scene whose only part combines them in one operation (not Leaf). Leaf i is operand i.
struct MeshScene {
    Scene scene;
    solid::Geometry geometry;
};

[[nodiscard]] MeshScene make_mesh_scene(ExpressionKind operation, std::span<const Mesh> operands);

/// Union, intersection or difference (first minus the others) of closed meshes, which may intersect themselves: inside
/// is where the winding number is not 0. Sources are indices of operands. Throws as make_mesh does, and
/// base::Stopped where `stop` asked for it.
[[nodiscard]] BooleanResult combine(ExpressionKind operation, std::span<const Mesh> operands,
                                    const std::stop_token& stop = {});

}  // namespace csg::reference
