// Patches among which the surface of a Minkowski sum is.
#pragma once

#include <optional>
#include <stop_token>

#include "csg/reference/convex.h"

namespace csg::reference {

/// The convolution of a closed, manifold surface that is oriented outwards with a convex polyhedron, without what can
/// be no boundary of the sum (Kaul and Rossignac 1991, Lien 2007): faces of `a` moved by the point of `b` that is
/// farthest along their normals; faces of `b` at the corners of `a` that are locally farthest along theirs; and the
/// parallelograms of edges of both where `a` is convex and some direction is a normal at both edges. The boundary of
/// the sum is among these patches, each of which has the sum behind it, all along. As if `b` were turned by 2^-35:
/// then nothing is parallel, so that faces and edges that are need no rules of their own. Patches overlap and cross.
/// Nothing where edges of `a` have not two faces, or the pairs of corners and faces are very many. Throws
/// base::Stopped where `stop` asked for it.
[[nodiscard]] std::optional<Mesh> convolution(const Mesh& a, const Convex& b, const std::stop_token& stop = {});

}  // namespace csg::reference
