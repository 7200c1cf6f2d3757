// Which planes the triangles of a scene get. Internal to csg/solid.
#pragma once

#include <cstdint>
#include <stop_token>

#include "csg/solid/placed.h"

namespace csg::solid {

/// The plane of a triangle by itself, outwards.
[[nodiscard]] Plane plane_of(const PlacedLeaf& leaf, std::uint32_t triangle);

/// The logarithm of its smallest height, in whole numbers: how well its plane is known.
[[nodiscard]] int accuracy(const PlacedLeaf& leaf, std::uint32_t triangle);

/// Fills the (empty) table and all leaves' `planes`. The widest triangles come first, so that an entry of the table is
/// as accurate as can be; equally wide ones by leaf and place in it.
void assign_planes(Geometry& geometry, const std::stop_token& stop = {});

}  // namespace csg::solid
