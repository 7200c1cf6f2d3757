// What engines that need a sum of products draw.
#pragma once

#include <span>

#include "goldfeather/products.h"

namespace goldfeather {

/// The products of a part, with the boxes of all leaves of the scene.
struct PartProducts {
    std::span<const Product> products;
    std::span<const csg::Box> leaf_boxes;  ///< World boxes by LeafId.
    std::span<const char> wound{};         ///< By LeafId, whether it has a winding number (Solid::winds); empty: none.
    std::span<const char> open{};  ///< By LeafId, whether its mesh is not closed: counted from the eye; empty: none.
};

}  // namespace goldfeather
