// A model of which some is not to be seen.
#pragma once

#include <optional>
#include <span>

#include "csg/tree/tree.h"

namespace csg {

/// The model without what the calls at `hidden` make, and, where `only` is given, nothing but what the calls there
/// make, where it lies in the model: a cutter is a solid by itself then. A difference whose first operand is hidden is
/// nothing. `%` parts are left out.
[[nodiscard]] Tree left_over(const Tree& tree, std::span<const SourceLocation> hidden,
                             const std::optional<SourceLocation>& only);

}  // namespace csg
