// Leaves that are combined with each other, apart from all others.
#pragma once

#include <span>
#include <vector>

#include "csg/solid/placed.h"

namespace csg::reference {

/// The operands of one arrangement: in its files a LeafId is a place in `leaves`.
struct LeafGroup {
    std::vector<const solid::PlacedLeaf*> leaves;
    std::span<const solid::Plane> planes;  ///< What the leaves' planes are places in.
    /// Encloses all that tolerances are to fit: the leaves, and what stands beside them in other groups.
    Box extent;

    [[nodiscard]] std::size_t triangles() const {
        std::size_t count = 0;
        for (const solid::PlacedLeaf* leaf : leaves) {
            count += leaf->triangles.size();
        }
        return count;
    }
};

}  // namespace csg::reference
