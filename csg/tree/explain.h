// What one operation of a model does, as a model of its own.
#pragma once

#include <string>
#include <vector>

#include "csg/tree/tree.h"

namespace csg {

/// Differences and intersections that the tree has a node of, in the order of their places.
[[nodiscard]] std::vector<const Statement*> explainable(const Tree& tree);

/// The model, with what the operation at that place did, wherever it was called from: what a difference removed, red
/// and seen through, with the rest of what it subtracted, gray and fainter; or, the model without colors, what an
/// intersection kept, green, and what it lost of its operands, red and seen through. What later operations took away
/// again of it is shown, too.
[[nodiscard]] Tree explained(const Tree& tree, const SourceLocation& where);

/// The model without the call at that place: of a difference its first operand, of an intersection the union of all, of
/// a transformation or a color what is below it, of anything else nothing.
[[nodiscard]] Tree without(const Tree& tree, const SourceLocation& where);

}  // namespace csg
