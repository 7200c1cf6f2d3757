// Convex sets within a solid that cover its surface.
#pragma once

#include <stop_token>
#include <vector>

#include "csg/reference/convex.h"

namespace csg::reference {

/// A solid for Minkowski sums: the union of meshes, by convex pieces.
struct ConvexCover {
    std::vector<Mesh> meshes;        ///< Closed, evenly oriented; inside is where the winding number is not zero.
    std::vector<Convex> pieces;      ///< Each within the solid; together they cover the surface of each mesh.
    std::vector<glm::dvec3> points;  ///< In each connected component of the solid one at least.
    bool convex = false;             ///< The solid is one piece.

    [[nodiscard]] bool holds(const glm::dvec3& point) const;
};

/// Replaces the pieces by fewer and larger ones (convex_growth.h), at a cost of the number of pieces times that of
/// faces.
void grow(ConvexCover& cover, const std::stop_token& stop = {});

/// A component of a mesh that is convex but for rounding (a tessellated sphere is) is one piece; of others the faces
/// are. Throws std::runtime_error where a mesh is not closed, base::Stopped
/// where `stop` asked for it.
[[nodiscard]] ConvexCover convex_cover(const std::vector<Mesh>& meshes, const std::stop_token& stop = {});

}  // namespace csg::reference
