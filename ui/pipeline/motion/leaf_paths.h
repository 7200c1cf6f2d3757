// The leaves of a scene by the calls that made them: what stays the same while a program runs again and again.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/tree/scene.h"

namespace ui {

struct LeafPath {
    std::uint64_t calls = 0;  ///< A hash of the places of all calls from the root down to the leaf.
    std::uint64_t shape = 0;  ///< A hash of what the leaf is, in its own coordinates.
};

/// By leaf. Leaves of one call that is run several times, as in a loop, have equal `calls`.
[[nodiscard]] std::vector<LeafPath> leaf_paths(const csg::Tree& tree, const csg::Scene& scene);

}  // namespace ui
