// Two versions of a model as one.
#pragma once

#include "csg/tree/tree.h"

namespace csg {

/// What a change of a model can be asked for.
struct Versions {
    Tree all;      ///< What both have, gray and seen through; what is new, green; what is gone, red.
    Tree added;    ///< What only the later one has.
    Tree removed;  ///< What only the earlier one has.
};

/// Solids less solids; `%` subtrees are no part of them, `#` is taken off. Nodes keep their places, and calls theirs.
[[nodiscard]] Versions versions(const Tree& before, const Tree& after);

}  // namespace csg
