// Whether prisms meet themselves, told in the plane.
#pragma once

#include <optional>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// `mesh` is closed and manifold, in one piece, oriented outwards, and all its triangles have an area. Where it is a
/// prism along x, y or z to the last bit (each corner of the lower face straight below one of the upper), whether
/// triangles of it meet anywhere but where they share corners: exactly where sides of its outline do. (What fills the
/// outline covers nothing twice then: all of it faces one way.) Caps of long combs consist of needles, nearly all pairs
/// of which would have to be looked at. Nothing where it is no such prism. Throws base::Stopped where `stop` asked for
/// it.
[[nodiscard]] std::optional<bool> prism_meets_itself(const Mesh& mesh, const std::stop_token& stop = {});

}  // namespace csg::reference
