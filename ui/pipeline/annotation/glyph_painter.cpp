#include "ui/pipeline/annotation/glyph_painter.h"

#include <algorithm>
#include <cmath>

#include "ui/pipeline/motion/tube.h"

namespace ui {

namespace {

constexpr double kThickness = 0.25;  // Pixels, of slabs.
constexpr csg::Rgba kArrow{0.85F, 0.2F, 0.15F, 1};

/// How far planes of glyphs are apart.
double step_of(const base::View& view, double front) {
    const double pixel = ScreenPlane(view, front).pixel();
    return view.orthographic() ? 2 * pixel : std::max(2 * pixel, 0.002 * front);
}

std::shared_ptr<const csg::solid::Solid> solid_of(csg::Polyhedron mesh) {
    return csg::solid::make_solid(std::make_shared<const csg::Polyhedron>(std::move(mesh)));
}

}  // namespace

GlyphPainter::GlyphPainter(const base::View& view, double front)
    : lines_(view, front),
      plates_(view, front - step_of(view, front)),
      rims_(view, front - 2 * step_of(view, front)),
      texts_(view, front - 3 * step_of(view, front)) {}

void GlyphPainter::slab(const ScreenPlane& plane, const csg::solid::Outline& outline, const glm::dvec2& corner,
                        const csg::Rgba& color) {
    glyphs_.push_back({slab_of(outline, kThickness), plane.to_world(corner), color});
}

void GlyphPainter::text(const csg::solid::Outline& outline, const glm::dvec2& corner, const csg::Rgba& color) {
    slab(texts_, outline, corner, color);
}

void GlyphPainter::plate(const csg::solid::Outline& outline, const csg::Rgba& color) {
    slab(plates_, outline, {0, 0}, color);
}

void GlyphPainter::ring(const csg::solid::Loop& outer, const csg::solid::Loop& inner, const csg::Rgba& color) {
    slab(rims_, {{outer, reversed(inner)}}, {0, 0}, color);
}

void GlyphPainter::leader(const glm::dvec2& from, const glm::dvec3* point, const glm::dvec2& to, double width,
                          const csg::Rgba& color) {
    const glm::dvec3 begin = point != nullptr ? *point : lines_.at(from), end = lines_.at(to);
    const double radius = 0.5 * width, share = point != nullptr ? glm::distance(begin, lines_.at(from)) : 0;
    // As wide in the picture where it is farther away.
    const double far = (lines_.distance() + share) / lines_.distance() * lines_.pixel();
    const TubePoint curve[]{{begin, radius * (point != nullptr ? far : lines_.pixel())},
                            {end, radius * lines_.pixel()}};
    glyphs_.push_back({solid_of(tube(curve)), glm::dmat4(1.0), color});
    constexpr double kDot = 2.2;
    csg::Sphere dot;
    dot.radius = 1;
    dot.fineness.fn = 12;
    glm::dmat4 placed(std::max(kDot, 2 * width) * (point != nullptr ? far : lines_.pixel()));
    placed[3] = glm::dvec4(begin, 1);
    glyphs_.push_back({csg::solid::make_solid(dot), placed, color});
}

void GlyphPainter::bubble(const PixelBox& box, const glm::dvec2& at, double line, const csg::Rgba& paper,
                          const csg::Rgba& ink) {
    const glm::dvec2 middle = 0.5 * (box.lo + box.hi);
    const glm::dvec2 way = at - middle;
    const double length = glm::length(way);
    constexpr double kBefore = 4;
    const auto shape = [&](double smaller) {
        const double radius = 0.4 * std::min(box.size().x, box.size().y);
        auto body = std::make_shared<csg::solid::Outline>();
        body->loops = {rounded_box(box.lo + smaller, box.hi - smaller, radius - smaller)};
        if (length < 1e-9) {
            return *body;
        }
        const glm::dvec2 ahead = way / length, aside = glm::dvec2(-ahead.y, ahead.x);
        const double half = 0.18 * box.size().y + 2 - smaller;
        // The tip of the inner shape lies as far within that of the outer as its sides do.
        const double back = kBefore + smaller * length / std::max(half + smaller, 1.0);
        auto tail = std::make_shared<csg::solid::Outline>();
        tail->loops = {{middle - half * aside, at - back * ahead, middle + half * aside}};
        const std::shared_ptr<const csg::solid::Outline> both[]{body, tail};
        return length > back + 1 ? csg::solid::combine(csg::solid::BooleanKind::Union, both) : *body;
    };
    plate(shape(0), ink);
    slab(rims_, shape(line), {0, 0}, paper);
}

void GlyphPainter::frame(const PixelBox& box, double line, const csg::Rgba& color) {
    ring(rounded_box(box.lo - line, box.hi + line, 4 * line), rounded_box(box.lo, box.hi, 3 * line), color);
}

void GlyphPainter::arrow(const ArrowRequest& request, double size) {
    constexpr double kOfModel = 0.004;
    const double radius = request.width ? 0.5 * *request.width : kOfModel * size;
    glyphs_.push_back(
        {solid_of(ui::arrow(smooth_curve(request.points), radius)), glm::dmat4(1.0), request.color.value_or(kArrow)});
}

std::vector<glm::dvec3> smooth_curve(std::span<const glm::dvec3> through, int pieces) {
    std::vector<glm::dvec3> curve;
    if (through.size() < 3) {
        return {through.begin(), through.end()};
    }
    const auto last = through.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const glm::dvec3 &a = through[i == 0 ? 0 : i - 1], &b = through[i], &c = through[i + 1],
                         &d = through[std::min(i + 2, last)];
        for (int k = 0; k < pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            curve.push_back(0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                                   t * t * t * (3.0 * (b - c) + d - a)));
        }
    }
    curve.push_back(through[last]);
    return curve;
}

}  // namespace ui
