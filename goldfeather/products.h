// Sums of products: a part's boolean expression as a union of intersections of literals.
// Goldfeather, Hultquist, Fuchs: Fast constructive solid geometry display in the Pixel-Powers graphics system (1986);
// Goldfeather, Molnar, Turk, Fuchs: Near real-time CSG rendering using tree normalization and geometric pruning (1989).
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "csg/tree/box.h"
#include "csg/tree/scene.h"

namespace goldfeather {

/// A leaf, or the complement of a leaf.
struct Literal {
    csg::LeafId leaf = 0;
    bool complement = false;
    auto operator<=>(const Literal&) const = default;
};

/// The intersection of literals, sorted by leaf. Has at least one literal that is not a complement.
struct Product {
    std::vector<Literal> literals;
    csg::Box box;  ///< Encloses the product: intersection of the boxes of its leaves that are not complements.
};

/// The limits of a normalization.
struct Budget {
    std::size_t products = 4096;    ///< Most products of one part.
    std::size_t literals = 262144;  ///< Most literals over all products of one part.
};

struct NormalizationStats {
    /// Products that plain rewriting would give, without pruning; saturates at 1e18.
    double products_unpruned = 0;
    std::size_t products = 0;
    std::size_t literals = 0;
    std::size_t pruned_products = 0;  ///< Known empty by their boxes, never expanded further.
    std::size_t pruned_literals = 0;  ///< Complements whose leaf cannot touch the product.
};

/// The three answers of a normalization.
struct SumOfProducts {
    std::vector<Product> products;
};
struct Empty {};
struct OverBudget {
    std::size_t products = 0;  ///< How many had been made when the budget was passed.
};
using Normalized = std::variant<SumOfProducts, Empty, OverBudget>;

/// Rewrites `part` to a sum of products, iteratively (no recursion on the depth of the model), interleaved with
/// pruning by `leaf_boxes` (indexed by LeafId, world coordinates; an empty box is a leaf without volume): a product
/// whose box has become empty or flat is dropped before it is expanded, a complement whose leaf does not overlap the
/// product's box is left out. Products and literals come out in document order; equal products are kept once.
[[nodiscard]] Normalized normalize(const csg::Scene& scene, const csg::Part& part, std::span<const csg::Box> leaf_boxes,
                                   const Budget& budget, NormalizationStats& stats);

}  // namespace goldfeather
