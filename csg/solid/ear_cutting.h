// Triangulation of a single loop, whatever it looks like.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace csg::solid {

/// A corner of a loop and what it is called in triangles.
struct Corner {
    glm::dvec2 at;
    std::uint32_t index;
};
using Ring = std::vector<Corner>;

/// Appends triangles that fill a ring of three corners or more by cutting off ears, counter-clockwise where it goes
/// around counter-clockwise. Every directed edge of the ring is an edge of exactly one triangle, every other edge of
/// two, in opposite directions, even of a ring that crosses itself; there the triangles fill no certain region.
void cut_ears(const Ring& ring, std::vector<glm::uvec3>& triangles);

}  // namespace csg::solid
