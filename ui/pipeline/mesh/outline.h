// A flat model as one region of the plane, for files and summaries.
#pragma once

#include "csg/solid/outline.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/model.h"

namespace ui {

/// What the solid and translucent parts of a model are, as far as they are not empty.
enum class Extent { None, Flat, Solid, Mixed };

[[nodiscard]] Extent extent_of(const Model& model);

/// Whether a preview shows outlines among solids or solids among outlines, which its result leaves out.
[[nodiscard]] bool shows_misplaced(const Model& model);

/// Throw ModelError, with places, where the model is not what a file of solids, or one of drawings, can hold: empty, in
/// the other dimension, or in both at once.
void need_solid(const Model& model);
void need_flat(const Model& model);

/// For summaries, in OpenSCAD's form: {"dimensions": 2, "convex": …, "contours": …, "area": …, "bounding_box": …}.
[[nodiscard]] Json to_json(const csg::solid::Outline& outline);

}  // namespace ui
