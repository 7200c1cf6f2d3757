// Which part's face is seen where faces of several parts coincide.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::solid {

/// Parts by precedence, the one that is seen first: highlights, then the solid, what is seen through, and `%`; of each
/// kind the more opaque, then the larger color (red, green, blue). What is left is told apart by its leaves, so that
/// the order of parts in the text makes no difference: parts that are equal in all of that look the same. `geometry`:
/// null where the scene has none; leaves of equal color are the same then.
[[nodiscard]] std::vector<PartId> part_order(const Scene& scene, const Geometry* geometry);

/// The same by part: its place in that order.
[[nodiscard]] std::vector<std::uint32_t> ranks_of(const std::vector<PartId>& order);

}  // namespace csg::solid
