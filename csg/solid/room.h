// What edits of a scene leave as it was.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "csg/tree/box.h"

namespace csg::solid {

/// What a scene had before it was edited, and keeps as far as it goes: numbers that concern all leaves then stay as
/// they are while one of them moves. A default room keeps nothing.
struct Room {
    Box box;           ///< Of all leaves.
    double reach = 0;  ///< The largest coordinate.

    /// What the tolerance of coincidence is made of, for a scene with that largest coordinate: the room's, or, where
    /// that is less, the next power of two.
    [[nodiscard]] double reach_for(double largest) const;
    /// Of what becomes floats, for a scene with that box: the middle of the room, unless the scene lies far outside;
    /// then its own, on a coarse grid. None: the box's.
    [[nodiscard]] std::optional<glm::dvec3> center_for(const Box& box) const;
    /// What half-spaces end at: a box with some room about `bounded`, that of all else. Of a scene that has not grown
    /// much it stays as it is.
    [[nodiscard]] Box around(const Box& bounded) const;
};

}  // namespace csg::solid
