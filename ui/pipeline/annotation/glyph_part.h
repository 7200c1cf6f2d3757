// A part of glyphs beside those of a model: no section cuts it, and no name of another part means it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "csg/solid/outline.h"
#include "csg/solid/solid.h"
#include "csg/tree/tree.h"
#include "ui/pipeline/model.h"

namespace ui {

struct PlacedGlyph {
    std::shared_ptr<const csg::solid::Solid> solid;
    glm::dmat4 to_world{1.0};
    csg::Rgba color;
};

/// The model with one more part, its last, of all glyphs united; named `name`, or that with a number where there is
/// such a part. The box is of both.
[[nodiscard]] std::shared_ptr<const Model> with_glyphs(const Model& model, std::span<const PlacedGlyph> glyphs,
                                                       const std::string& name = "labels");

/// A slab that thick over an outline.
[[nodiscard]] std::shared_ptr<const csg::solid::Solid> slab_of(const csg::solid::Outline& outline, double thickness);

/// Outlines that glyphs are made of; a circle of 32 sides, corners rounded with as many to a turn.
[[nodiscard]] csg::solid::Loop circle(const glm::dvec2& middle, double radius);
[[nodiscard]] csg::solid::Loop rounded_box(const glm::dvec2& lo, const glm::dvec2& hi, double radius);
/// The same the other way round: as a hole.
[[nodiscard]] csg::solid::Loop reversed(csg::solid::Loop loop);

}  // namespace ui
