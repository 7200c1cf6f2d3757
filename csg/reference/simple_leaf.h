// Leaves whose surface is the boundary of their inside as it is.
#pragma once

#include <optional>
#include <stop_token>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"

namespace csg::reference {

/// The leaf's triangles, if they are one closed, manifold surface oriented outwards that meets itself nowhere (exact
/// predicates; of a leaf known to be convex it is not asked), all with an area: then it is what any boolean would
/// make of it. Nothing where it is not, or cannot be told. All sources are 0.
struct SimpleSurface {
    Mesh mesh;
    MeshFacts facts;
};
[[nodiscard]] std::optional<SimpleSurface> simple_surface(const solid::PlacedLeaf& leaf, const std::stop_token& stop);

}  // namespace csg::reference
