// Leaves that reach far beyond what can be seen are cut off there.
#pragma once

#include <optional>
#include <span>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::solid {

/// What a leaf may reach beyond its part's box on each side, in diagonals of that box.
inline constexpr double kFarthestReach = 64;

/// Cuts every closed leaf that reaches farther than `kFarthestReach` beyond the box of its part (a subtrahend, or one
/// side of an intersection, of 1e10, as people write for "endless") down to that reach. The result of the part lies in
/// its box, so nothing of it changes; but depth, and the tolerance of coincidence, need not span what nobody sees. Cuts
/// are closed by triangles from one of their points: for convex leaves a convex face, for others one that overlaps
/// itself, where the directions of its triangles add up to the winding numbers of the leaf, and so do their parities.
/// `planes` must not be assigned yet.
void trim_leaves(const Scene& scene, std::span<PlacedLeaf> leaves);

/// What leaves of a part are cut down to; none where it is empty. `boxes`: of all leaves, uncut.
[[nodiscard]] std::optional<Box> trim_limit(const Scene& scene, const Part& part, std::span<const Box> boxes);

/// Cuts one closed leaf down to the box.
void trim_leaf(PlacedLeaf& leaf, const Box& limit);

}  // namespace csg::solid
