// Faces of roofs, as loops of point numbers.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace csg::reference {

/// The loop without steps from a point to itself and without ways forth and back. The directed edges that are left out
/// are pairs of opposite ones, so closed sets of faces stay closed.
[[nodiscard]] std::vector<std::uint32_t> reduced(std::span<const std::uint32_t> loop);

/// Appends triangles that fill a face, counter-clockwise from above, in time that grows with its corners. Its corners
/// must follow each other along its last edge, the eaves, as those over an edge of an outline do.
void triangulate_over_eaves(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                            std::vector<glm::uvec3>& triangles);

}  // namespace csg::reference
