// The box of what is left of a model after all its differences and intersections, without its mesh.
#pragma once

#include "ui/pipeline/model.h"

namespace ui {

/// The smallest box (world coordinates) about the surfaces of the solid and translucent parts; empty where there are
/// none. Model::box only encloses it.
///
/// Each side is found by looking at the model from there: the nearest surface of an orthographic picture, then closer
/// and closer pictures of where it was, then the corners of leaves that stand out beyond. Where a side of the result
/// has the coordinate of a corner of a leaf, as nearly always, it is that number; else it is within 2⁻²⁰ of the box's
/// diagonal. A tip that is no corner of a leaf, and thinner than 2⁻⁹ of the box across, may be missed. Same model, same
/// box on every machine. Throws base::Stopped where `stop` asked for it.
[[nodiscard]] csg::Box exact_bounds(const Model& model, const std::stop_token& stop = {});

}  // namespace ui
