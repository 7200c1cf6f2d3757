// Roofs over outlines.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The closed roof over a region (outer loops counter-clockwise, holes clockwise, none crossing) whose faces rise at 45
/// degrees from its edges: the straight skeleton (Aichholzer and others 1995). Throws std::runtime_error where CGAL
/// finds none.
[[nodiscard]] Mesh roof(std::span<const std::vector<glm::dvec2>> loops, const std::stop_token& stop = {});

}  // namespace csg::reference
