// Flat areas of a surface, filled anew with no more triangles than their outlines need.
#pragma once

#include <span>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// `mesh` is closed and manifold, and `sources[t]` tells the kind of triangle t: neighbors of one kind lie in one plane
/// (outward normal normals[kind], of any length) and are one area. Points within areas go, and so do points on the
/// straight lines between two of them, on both sides of the line; each area that has lost points is triangulated
/// (constrained Delaunay). What goes lies on what stays, up to the rounding of coordinates. An area whose outline
/// crosses itself by rounding stays as it is. `sources` are kinds as before; unused points are dropped. A mesh that is
/// not closed and manifold is left alone. Throws base::Stopped where `stop` asked for it.
void merge_flat_areas(Mesh& mesh, std::span<const glm::dvec3> normals, const std::stop_token& stop = {});

}  // namespace csg::reference
