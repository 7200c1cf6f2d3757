// A model with more beside it than its text says.
#pragma once

#include <span>

#include "csg/tree/tree.h"

namespace csg {

/// A shape, or a subtree of some tree, where and in what color it is to be drawn. Opaque shapes are united with the
/// model's solid, others are parts of their own, as of color() in a text.
struct Addition {
    LeafShape shape;             ///< Where there is no tree.
    const Tree* tree = nullptr;  ///< Must outlive the call.
    NodeId node = kNoNode;       ///< Of the tree.
    glm::dmat4 to_world{1.0};
    Rgba color;
};

/// The model, its modifiers and places as they are, and the additions.
[[nodiscard]] Tree with_additions(const Tree& model, std::span<const Addition> additions);

}  // namespace csg
