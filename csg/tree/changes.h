// Two versions of a model as one.
#pragma once

#include <vector>

#include "csg/tree/tree.h"

namespace csg {

// Of both trees: `%` subtrees are no part of the solid, `#` is taken off; nodes keep their places, and calls theirs.

/// What both have, gray and seen through; what is new in the later one, green; what is gone, red.
[[nodiscard]] Tree changes(const Tree& before, const Tree& after);

/// The solid of one less that of the other.
[[nodiscard]] Tree less(const Tree& first, const Tree& second);

/// Both as children of one root, and what their nodes have become in it, by their ids; kNoNode of `%` subtrees.
struct JoinedTrees {
    Tree tree;
    std::vector<NodeId> first, second;
};
[[nodiscard]] JoinedTrees joined(const Tree& first, const Tree& second);

}  // namespace csg
