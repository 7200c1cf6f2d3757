// What has become different in a scene that is edited: for those who keep something made of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/tree/scene.h"

namespace csg::solid {

/// Since the last one. All numbers are those of now.
struct SceneChange {
    /// Leaves or expressions have come or gone: leaves have other numbers. What was made of the scene is to be made
    /// anew; nothing else of what is here counts then, but the failures.
    bool structure = false;
    /// Geometry::center has moved: all that floats were made of has.
    bool center = false;
    /// All planes have other numbers, and triangles of any leaf may have others.
    bool all_planes = false;
    std::vector<std::uint32_t> planes;  ///< Entries of the plane table that are others.
    std::vector<LeafId> leaves;         ///< Whose triangles, planes or boxes are others.
    std::vector<PartId> parts;          ///< Of these leaves, and those shown or hidden.
    std::vector<std::string> failures;  ///< Leaves that could not be placed so, and are left out.

    [[nodiscard]] bool empty() const {
        return !structure && !center && !all_planes && planes.empty() && leaves.empty() && parts.empty();
    }
};

}  // namespace csg::solid
