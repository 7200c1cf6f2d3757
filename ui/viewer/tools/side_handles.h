// Handles at sides of a leaf's box whose dimensions are computed: where they are dragged to, and what that looks like
// until the text follows.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "ui/pipeline/editable_model.h"
#include "ui/pipeline/editing/shape_numbers.h"

namespace ui {

struct SideHandle {
    std::string name;            ///< "x", "r", "h"
    int axis = 0;                ///< Of the leaf's coordinates; it is the upper side along it.
    glm::dvec3 at{0}, along{0};  ///< World coordinates; outwards, of length 1.
    double length = 0;           ///< What its name stands for, in units of the leaf.
    double world_per_unit = 1;   ///< How far the side goes where that grows by one.
    HeldPart preview;            ///< But for its scale and how far: the pivot and the axes.
    glm::bvec3 grows{false};     ///< Along which axes the leaf does.
    double extent = 0;           ///< World units, from the pivot to the side.

    /// The leaf as it will look with that side farther out, at most down to nothing.
    [[nodiscard]] HeldPart moved_out(double by) const;
};

/// Of axes that none of the numbers lies along. The leaf is that of the occurrence.
[[nodiscard]] std::vector<SideHandle> side_handles(const csg::Tree& tree, const csg::LeafInstance& leaf,
                                                   std::span<const ShapeNumber> numbers);

}  // namespace ui
