// The surface of a solid among patches that hold it.
#pragma once

#include <functional>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The boundary of a solid, closed and manifold, in flat areas with no more triangles than their outlines need; all
/// sources are 0. The boundary is part of `patches`, triangles that may overlap, cross and end anywhere; each has the
/// solid behind it, so that what two of them face from both sides is inside. `inside(p)`: is the point, which lies
/// before a patch by 64 times the tolerance of planes, in the solid? It is asked once for each piece of the patches
/// between the lines where they meet; pieces that end somewhere are inside without being asked. Throws Undecided
/// (segments.h) where that gives no closed surface: patches are within the tolerance of being degenerate; base::Stopped
/// where `stop` asked for it.
[[nodiscard]] Mesh surface_of_patches(const Mesh& patches, const std::function<bool(const glm::dvec3&)>& inside,
                                      const std::stop_token& stop = {});

/// Throws Undecided where the mesh is not the surface of a solid: not closed, without a volume, or it crosses itself.
void check_surface(const Mesh& mesh, const std::stop_token& stop = {});

}  // namespace csg::reference
