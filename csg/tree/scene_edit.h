// Leaves that no text made, put into the expressions of a scene and taken out again.
#pragma once

#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace csg {

/// The expression of a part, or of what of an occurrence is in it.
struct Site {
    PartId part = 0;
    OccurrenceId occurrence = kNoOccurrence;  ///< None: all of the part.
};

/// An index into Scene::expressions; kNoExpression where nothing of the occurrence is in the part.
inline constexpr std::uint32_t kNoExpression = ~std::uint32_t{0};
[[nodiscard]] std::uint32_t expression_at(const Scene& scene, const Site& site);

/// By occurrence: 1 for this one and all below it.
[[nodiscard]] std::vector<char> occurrences_below(const Scene& scene, OccurrenceId occurrence);

/// Puts `leaf` in the place of what is at the site, together with it: united with it, intersected with it, or
/// subtracted from it; something must be there. The whole is the site's then. Gives the leaf's number, the next after
/// those at the site; leaves and expressions behind it get others. `operation`: not Leaf.
LeafId insert_leaf(Scene& scene, const Site& site, ExpressionKind operation, LeafInstance leaf);

/// Subtracts what the part `tool` is from each part that `cut` (by part) names by 1, with leaves of the part's own for
/// it, which have its color and a hatching. Leaves and expressions get other numbers, parts do not; `tool` stays.
void subtract_part(Scene& scene, PartId tool, std::span<const char> cut);

/// Undoes insert_leaf.
void erase_leaf(Scene& scene, LeafId inserted);

}  // namespace csg
