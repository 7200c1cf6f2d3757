// Triangulation of the faces of a polyhedron.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace csg::solid {

/// Appends triangles that fill the loop `face` of indices into `points` to `triangles`, in the loop's orientation. A
/// bent face is split as OpenSCAD splits it (bent_face.h). A flat convex
/// face is split evenly, large triangles first; others by a sweep in the projection along the face's normal
/// (Newell), or by ears if they cross themselves there. Every directed edge of the loop is an edge of exactly one
/// triangle, whatever the loop looks like, so a closed set of faces gives a closed mesh.
void triangulate(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                 std::vector<glm::uvec3>& triangles);

/// The same for a face that is known to be convex.
void triangulate_convex(std::span<const std::uint32_t> face, std::vector<glm::uvec3>& triangles);

}  // namespace csg::solid
