// The box of what is left of a model after all its differences and intersections, without its mesh.
#pragma once

#include "ui/pipeline/model.h"

namespace ui {

/// The smallest box (world coordinates) about the surfaces of the solid and translucent parts; empty where there are
/// none. Model::box only encloses it.
///
/// Each side is found by looking at the model from there: the nearest surface of an orthographic picture, and then
/// closer and closer pictures of where it was. Where a side of the result has the coordinate of a corner of a leaf, as
/// nearly always, it is that number; else it is within 2⁻²⁰ of the box's diagonal. A tip thinner than 2⁻⁹ of the box
/// in both directions across may be missed. Same model, same box on every machine.
[[nodiscard]] csg::Box exact_bounds(const Model& model);

}  // namespace ui
