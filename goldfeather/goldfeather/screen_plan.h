// What a view leaves of a sum of products: where leaves and products lie on the screen, and who shares what.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/camera.h"
#include "csg/tree/box.h"
#include "goldfeather/products.h"

namespace goldfeather {

/// Pixels x0 ≤ x < x1, y0 ≤ y < y1, from the lower left corner.
struct PixelBox {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
};

[[nodiscard]] inline bool overlap(const PixelBox& a, const PixelBox& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// A leaf that is drawn: in the view, and a literal of some product in the view.
struct PlannedLeaf {
    PixelBox box;
    csg::LeafId leaf = 0;
    /// Which parity bit the leaf toggles, or, from ScreenPlan::first_counter() · 32 on, which word · 32 it is counted
    /// in.
    std::uint32_t slot = 0;
};

/// Literals of a product by word of 32 slots.
struct Entry {
    std::uint32_t word = 0;
    std::uint32_t set = 0;    ///< Slots whose leaf must hold the point.
    std::uint32_t clear = 0;  ///< Slots whose leaf must not.
    std::uint32_t unused = 0;
};

struct PlannedProduct {
    PixelBox box;  ///< The product can be true only here.
    std::uint32_t first_entry = 0;
    std::uint32_t entry_count = 0;
};

/// A square of the picture with the products and leaves that reach it. Tiles that nothing reaches are left out.
struct Tile {
    PixelBox box;
    std::uint32_t first_product = 0, product_count = 0;  ///< Into ScreenPlan::tile_products.
    std::uint32_t first_leaf = 0, leaf_count = 0;        ///< Into ScreenPlan::tile_leaves; in order of leaf id.
};

/// A leaf's parity needs a bit in every pixel, but leaves that are apart on the screen can share one (a slot), as long
/// as no product takes one of them for the other: five hundred holes of a plate need a few slots, not five hundred.
/// A leaf with winding numbers needs a whole word in every pixel instead of a bit; leaves share words as they share
/// bits.
struct ScreenPlan {
    std::vector<PlannedLeaf> leaves;  ///< In order of leaf id.
    std::vector<PlannedProduct> products;
    std::vector<Entry> entries;
    std::vector<Tile> tiles;
    std::vector<std::uint32_t> tile_products;  ///< Indices into `products`.
    std::vector<std::uint32_t> tile_leaves;    ///< Indices into `leaves`.
    std::uint32_t slots = 0;                   ///< Of parities.
    std::uint32_t counters = 0;                ///< Words of winding numbers, behind those of the parities.
    PixelBox box;                              ///< Of all products.

    [[nodiscard]] std::uint32_t first_counter() const { return (slots + 31) / 32; }
    [[nodiscard]] std::uint32_t words() const { return first_counter() + counters; }
};

/// `leaf_boxes`: world boxes by LeafId. Products outside the view, and leaves that no product in the view needs, are
/// not planned. `wound`: as in PartProducts.
[[nodiscard]] ScreenPlan plan(const base::View& view, std::span<const Product> products,
                              std::span<const csg::Box> leaf_boxes, std::span<const char> wound = {});

}  // namespace goldfeather
