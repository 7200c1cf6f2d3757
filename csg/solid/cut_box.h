// Half-spaces as closed meshes.
#pragma once

#include <cstdint>
#include <memory>

#include "csg/solid/plane_table.h"
#include "csg/solid/solid.h"

namespace csg::solid {

struct CutBox {
    std::shared_ptr<const Solid> solid;  ///< Convex, at most seven faces; without triangles where nothing is left.
    std::uint32_t face_triangles = 0;  ///< The first so many triangles lie in the plane; their outside is its normal's.
};

/// What of the box lies where dot(normal, p) ≤ offset. A half-space is drawn as this, with the scene's bounds and some
/// room about them as the box: every engine draws closed meshes, and none needs to know of surfaces that have no
/// bounds. Corners in the plane are as near to it as doubles are.
[[nodiscard]] CutBox cut_box(const Box& box, const Plane& plane);

}  // namespace csg::solid
