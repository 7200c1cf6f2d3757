// Small trees of solids and booleans from bytes.
#pragma once

#include "csg/tree/tree.h"
#include "tests/fuzz/bytes.h"

namespace fuzz {

struct SolidTree {
    csg::Tree tree;
    /// All faces lie in planes x, y or z = a whole number, exactly: the volume is a number of unit cubes.
    bool of_unit_cubes = false;
};

/// Boxes, tetrahedra, prisms and revolutions of outlines of any kind, polyhedra of several shells (overlapping,
/// reversed, doubled), rings of tube and double cones that pass through themselves, in either orientation. Corners are
/// points of a grid of 8 by 8 by 8; in half of the trees leaves are a little off it, or turned. All leaves are closed.
[[nodiscard]] SolidTree solid_tree(Bytes& bytes);

}  // namespace fuzz
