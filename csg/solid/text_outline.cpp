#include "csg/solid/text_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "csg/solid/fonts.h"
#include "csg/solid/solid.h"

#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

namespace csg::solid {
namespace {

constexpr std::size_t kMostTextBytes = 1 << 16;

/// Turns FreeType's outline into loops; curves become `segments` lines each.
struct Pen {
    std::vector<Loop>& loops;
    unsigned segments;
    glm::dvec2 offset;
    glm::dvec2 at{0.0};

    void add(const glm::dvec2& p) { loops.back().push_back(p + offset); }
    static glm::dvec2 point(const FT_Vector* v) { return {static_cast<double>(v->x), static_cast<double>(v->y)}; }
    static int move(const FT_Vector* to, void* self) {
        Pen& pen = *static_cast<Pen*>(self);
        pen.loops.emplace_back();
        pen.add(pen.at = point(to));
        return 0;
    }
    static int line(const FT_Vector* to, void* self) {
        Pen& pen = *static_cast<Pen*>(self);
        pen.add(pen.at = point(to));
        return 0;
    }
    static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
        Pen& pen = *static_cast<Pen*>(self);
        const glm::dvec2 a = pen.at, b = point(control), c = point(to);
        for (unsigned i = 1; i <= pen.segments; ++i) {
            const double t = static_cast<double>(i) / pen.segments, u = 1 - t;
            pen.add(a * (u * u) + b * (2 * u * t) + c * (t * t));
        }
        pen.at = c;
        return 0;
    }
    static int cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* self) {
        Pen& pen = *static_cast<Pen*>(self);
        const glm::dvec2 a = pen.at, b = point(first), c = point(second), d = point(to);
        for (unsigned i = 1; i <= pen.segments; ++i) {
            const double t = static_cast<double>(i) / pen.segments, u = 1 - t;
            pen.add(a * (u * u * u) + b * (3 * u * u * t) + c * (3 * u * t * t) + d * (t * t * t));
        }
        pen.at = d;
        return 0;
    }
};

constexpr FT_Outline_Funcs kPen{Pen::move, Pen::line, Pen::conic, Pen::cubic, 0, 0};

/// In a font that has no metrics for vertical text every letter stands in the middle of a line's height, which is
/// FreeType's (and so OpenSCAD's) and not HarfBuzz's.
void set_below_each_other(const Font& font, std::vector<Glyph>& glyphs) {
    const auto* os2 = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(font.face, FT_SFNT_OS2));
    if (FT_HAS_VERTICAL(font.face) || os2 == nullptr || os2->version == 0xFFFF) {
        return;
    }
    const int line = os2->sTypoAscender - os2->sTypoDescender;
    for (Glyph& glyph : glyphs) {
        hb_position_t x = 0, y = 0;
        hb_font_get_glyph_v_origin(font.shaper.get(), glyph.index, &x, &y);
        hb_glyph_extents_t box{};
        hb_font_get_glyph_extents(font.shaper.get(), glyph.index, &box);
        const hb_position_t middle = (line + box.height) / 2;  // Whole units, as fonts have them.
        glyph.offset.y += y - (box.y_bearing + middle);
        glyph.advance.y -= line + hb_font_get_glyph_v_advance(font.shaper.get(), glyph.index);
    }
}

/// Where the text's origin is, so that it stands as asked: extents in font units.
glm::dvec2 alignment(const Text& text, const glm::dvec2& advance, const Box& box) {
    const bool vertical = text.direction == "ttb" || text.direction == "btt";
    glm::dvec2 shift(0.0);
    if (text.halign == "center") {
        shift.x = vertical ? 0 : -advance.x / 2;
    } else if (text.halign == "right") {
        shift.x = vertical ? -box.hi.x : -advance.x;
    } else if (text.halign == "left" && vertical) {
        shift.x = -box.lo.x;
    }
    if (box.empty()) {
        return shift;
    }
    if (text.valign == "top") {
        shift.y = vertical ? 0 : -box.hi.y;
    } else if (text.valign == "center") {
        shift.y = vertical ? -advance.y / 2 : -(box.lo.y + box.hi.y) / 2;
    } else if (text.valign == "bottom") {
        shift.y = vertical ? -advance.y : -box.lo.y;
    }
    return shift;
}

}  // namespace

Outline text_outline(const Text& text, FontLibrary& fonts) {
    if (text.text.empty() || !(text.size > 0) || !std::isfinite(text.size) || !std::isfinite(text.spacing)) {
        return {};
    }
    if (text.text.size() > kMostTextBytes) {
        throw GeometryError(fmt::format("text() is longer than {} bytes", kMostTextBytes));
    }
    const Font* font = fonts.impl().find(text);
    if (font == nullptr) {
        throw GeometryError(fmt::format("Can't get font {}", text.font));
    }
    const int around = circle_segments(text.size, text.fineness);
    const unsigned segments = static_cast<unsigned>(std::max(around / 8 + 1, 2));
    glm::dvec2 pen(0.0);
    std::vector<std::shared_ptr<const Outline>> letters;
    Box box;
    std::vector<Glyph> glyphs = shape(text, font->shaper.get());
    if (text.direction == "ttb" || text.direction == "btt") {
        set_below_each_other(*font, glyphs);
    }
    for (const Glyph& glyph : glyphs) {
        if (FT_Load_Glyph(font->face, glyph.index, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) == 0) {
            std::vector<Loop> loops;
            Pen outline{loops, segments, pen + glyph.offset};
            FT_Outline_Decompose(&font->face->glyph->outline, &kPen, &outline);
            box = enclose(box, bounds_of(loops));
            letters.push_back(std::make_shared<Outline>(clean(loops, FillRule::NonZero)));
        }
        pen += glyph.advance * text.spacing;
    }
    const double scale = text.size * kEmPerSize / font->units;
    const glm::dvec2 shift = alignment(text, pen, box) * scale;
    glm::dmat4 matrix(1.0);
    matrix[0][0] = matrix[1][1] = scale;
    matrix[3] = glm::dvec4(shift, 0.0, 1.0);
    return transform(combine(BooleanKind::Union, letters), matrix);
}

}  // namespace csg::solid
