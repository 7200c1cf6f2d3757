// Solids from outlines.
#pragma once

#include <memory>

#include "csg/solid/outline.h"
#include "csg/solid/solid.h"

namespace csg::solid {

/// OpenSCAD's linear_extrude(): the same rings of vertices. Throws GeometryError where they are too many.
[[nodiscard]] std::shared_ptr<Solid> linear_extrude(const Outline& outline, const LinearExtrude& how);

/// OpenSCAD's rotate_extrude(). An outline on both sides of the axis gives a solid without triangles and a
/// failure. Throws GeometryError where there are too many vertices.
[[nodiscard]] std::shared_ptr<Solid> rotate_extrude(const Outline& outline, const RotateExtrude& how);

/// How an outline by itself is drawn: a slab of thickness 1 about z = 0, as OpenSCAD's preview does; `flat` is set.
[[nodiscard]] std::shared_ptr<Solid> slab(const Outline& outline);

/// Sets the box, `closed`, `convex` and `simple` from points and triangles; and estimates groups, where there are none.
void finish(Solid& solid);

}  // namespace csg::solid
