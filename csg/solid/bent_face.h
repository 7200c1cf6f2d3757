// Triangulation of a face whose corners do not lie in a plane.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace csg::solid {

/// Appends triangles that fill the loop `face` of four or more indices into `points`, in the loop's orientation, split
/// as OpenSCAD splits it: seen along an axis (of the normal of the largest triangle on its longest side) it is swept
/// from its right end (Preparata and Shamos 1985, section 6.2.3), then edges are flipped that Delaunay's rule forbids
/// clearly (Lawson 1977). False, with nothing appended, where the corners lie in a plane, or so nearly that it does not
/// show how the face is split, and where the loop crosses itself in that view.
[[nodiscard]] bool triangulate_bent(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                                    std::vector<glm::uvec3>& triangles);

}  // namespace csg::solid
