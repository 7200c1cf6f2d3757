// The numbers of a shape's own call that are its dimensions, for hands to change.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "csg/scad/syntax/call_text.h"
#include "csg/tree/leaf_shape.h"

namespace ui {

struct ShapeNumber {
    std::string name;            ///< "x", "h", "r1"
    csg::scad::ByteRange bytes;  ///< Of the number, in the text.
    double value = 0;
    glm::dvec3 at{0}, along{0};  ///< Where it is seen, and the way that it grows; leaf coordinates, of length 1.
    double per_unit = 1;         ///< How much more it is for a unit farther: 2 of diameters and of what is centered.
};

/// Of cubes, spheres and cylinders, as far as they are written out in the call; none of other shapes. `text`: that the
/// call stands in.
[[nodiscard]] std::vector<ShapeNumber> shape_numbers(const csg::LeafShape& shape, const csg::scad::CallText& call,
                                                     const std::string& text);

}  // namespace ui
