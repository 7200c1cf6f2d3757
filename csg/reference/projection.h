// Projections of a mesh onto the plane z = 0.
#pragma once

#include "csg/reference/mesh.h"

namespace csg::reference {

/// Outlines in the plane, filled by the even-odd rule; no two of them cross.
struct Outlines {
    std::vector<std::vector<glm::dvec2>> loops;
    [[nodiscard]] double area() const;  ///< Signed: outer loops run counter-clockwise, holes clockwise.
};

/// `cut`: the section of the closed mesh just below z = 0 (what only stands on the plane is
/// not part of it). Otherwise the shadow along z.
[[nodiscard]] Outlines projection(const Mesh& mesh, bool cut);

}  // namespace csg::reference
