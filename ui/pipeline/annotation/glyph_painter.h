// Glyphs that are given in pixels, made as solids before the scene.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/camera.h"
#include "ui/pipeline/annotation/annotation.h"
#include "ui/pipeline/annotation/glyph_part.h"
#include "ui/pipeline/annotation/screen_plane.h"
#include "ui/pipeline/annotation/text_shape.h"

namespace ui {

/// Coordinates are pixels from the picture's lower left corner. Lines lie behind plates, plates behind texts.
class GlyphPainter {
  public:
    /// `front`: the distance of the lines from the eye's plane.
    GlyphPainter(const base::View& view, double front);

    void text(const csg::solid::Outline& outline, const glm::dvec2& corner, const csg::Rgba& color);
    void plate(const csg::solid::Outline& outline, const csg::Rgba& color);
    /// Between two loops.
    void ring(const csg::solid::Loop& outer, const csg::solid::Loop& inner, const csg::Rgba& color);
    /// From a dot at `from` to `to`; with a `point` of the world, from there through the scene.
    void leader(const glm::dvec2& from, const glm::dvec3* point, const glm::dvec2& to, double width,
                const csg::Rgba& color);
    /// A rounded box with a tail that ends just before `at`.
    void bubble(const PixelBox& box, const glm::dvec2& at, double line, const csg::Rgba& paper, const csg::Rgba& ink);
    void frame(const PixelBox& box, double line, const csg::Rgba& color);
    /// In the world. `size`: of the model.
    void arrow(const ArrowRequest& request, double size);

    [[nodiscard]] std::span<const PlacedGlyph> glyphs() const { return glyphs_; }

  private:
    void slab(const ScreenPlane& plane, const csg::solid::Outline& outline, const glm::dvec2& corner,
              const csg::Rgba& color);

    ScreenPlane lines_, plates_, rims_, texts_;
    std::vector<PlacedGlyph> glyphs_;
};

/// Points of a smooth curve through the given ones (Catmull and Rom 1974), so many to a piece.
[[nodiscard]] std::vector<glm::dvec3> smooth_curve(std::span<const glm::dvec3> through, int pieces = 16);

}  // namespace ui
