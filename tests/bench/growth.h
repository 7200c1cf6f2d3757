// Families of models that grow, up to a hundred thousand leaves: cost against size.
#pragma once

#include <vector>

#include "tests/stability/family.h"

namespace bench {

/// Some of the families of hard models (tests/stability), at larger levels, and sphere piles and gear trains.
[[nodiscard]] std::vector<stability::Family> growing_families();

}  // namespace bench
