// What peeling a picture cost, whichever engine did it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "layers/limits.h"

namespace goldfeather {

struct WalkStats {
    int passes = 0;               ///< Geometry passes.
    int bands = 0;                ///< Pieces that the picture was split into to keep the memory budget.
    std::uint64_t fragments = 0;  ///< Surfaces of leaves in pixels that the engine looked at.
    std::uint32_t drawn_leaves = 0;
    std::uint32_t drawn_products = 0;  ///< Where the engine needs a sum of products.
    // Leaves (in lists) and products that a picture has nothing of: outside the view, or of no product in it.
    std::uint32_t skipped_leaves = 0, skipped_products = 0;
    /// Of drawn leaves: none of the layers found, in any pixel, is a surface of theirs. Known to `lists-cpu` only.
    std::optional<std::uint32_t> occluded_leaves;
    std::uint64_t skipped_triangles = 0;  ///< Of drawn leaves: they cover no sample. Known to `lists-cpu` only.
    std::uint32_t slots = 0;              ///< Parity bits per pixel, where the engine keeps them.
    std::uint32_t longest_list = 0;       ///< Most surfaces along a ray, where the engine keeps lists.
    std::size_t memory = 0;               ///< Bytes of per-pixel state and lists at once.
    int layers = 0;                       ///< The most layers of any pixel, as far as it was asked for.
    std::string fallback;                 ///< Why `lists-cpu` drew instead of the engine meant; empty where it did not.
};

using layers::kAllLayers;

/// Bytes of per-pixel state before a picture is split.
inline constexpr std::size_t kDefaultMemoryBudget = std::size_t{128} << 20;

}  // namespace goldfeather
