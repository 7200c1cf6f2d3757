// Random loops of the hard kinds: crossing, touching, nested, with repeated points and spikes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/solid/outline.h"

namespace outlines {

/// The same for the same seed. Coordinates mostly from a small grid, so that degeneracies are frequent; some turned by
/// odd angles, some with noise of any size, from far below the grid of outlines to well above, some far away.
[[nodiscard]] std::vector<csg::solid::Loop> random_loops(std::uint64_t seed);

/// As polygon() with paths.
[[nodiscard]] std::string as_scad(const std::vector<csg::solid::Loop>& loops);

}  // namespace outlines
