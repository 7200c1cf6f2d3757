// Measures of text, by the way OpenSCAD takes them: the glyphs of a very large size, scaled down.
#include <fmt/format.h>
#include <hb-ft.h>

#include <algorithm>
#include <limits>

#include "csg/solid/fonts.h"
#include "csg/solid/text_outline.h"
#include "csg/tree/box.h"

#include FT_GLYPH_H

namespace csg::solid {
namespace {

/// In 64ths of a point, at a resolution that makes the em kEmPerSize times as large; metrics are divided by it.
constexpr FT_F26Dot6 kSize = 100'000;
constexpr FT_UInt kResolution = 100;
constexpr double kScale = kSize;

using FtGlyph = std::unique_ptr<std::remove_pointer_t<FT_Glyph>, Destroy<FT_Done_Glyph>>;

/// The face of a text's font, set to the large size; null (and a warning) where there is none.
FT_Face sized_face(const Text& text, FontLibrary& fonts, std::vector<std::string>& warnings) {
    const Font* const font = fonts.impl().find(text);
    if (font == nullptr || FT_Set_Char_Size(font->face, 0, kSize, kResolution, kResolution) != 0) {
        warnings.push_back(fmt::format("Can't get font {}", text.font));
        return nullptr;
    }
    return font->face;
}

/// The box around a glyph's ink, on whole pixels; empty where it has none.
Box ink_of(FT_Face face, std::uint32_t index) {
    FT_Glyph glyph = nullptr;
    if (FT_Load_Glyph(face, index, FT_LOAD_DEFAULT) != 0 || FT_Get_Glyph(face->glyph, &glyph) != 0) {
        return {};
    }
    const FtGlyph owner(glyph);
    FT_BBox box;
    FT_Glyph_Get_CBox(glyph, FT_GLYPH_BBOX_GRIDFIT, &box);
    if (box.xMax <= box.xMin || box.yMax <= box.yMin) {
        return {};
    }
    const auto point = [](FT_Pos x, FT_Pos y) {
        return glm::dvec3(static_cast<double>(x), static_cast<double>(y), 0.0) / kScale;
    };
    return enclose(enclose(Box(), point(box.xMin, box.yMin)), point(box.xMax, box.yMax));
}

double unknown(std::string_view parameter, std::string_view words, const std::string& word,
               std::vector<std::string>& warnings) {
    warnings.push_back(fmt::format("Unknown value for the {} parameter (use {}): '{}'", parameter, words, word));
    return 0;
}

/// What the alignment does to a text whose ink lies in that box.
glm::dvec2 offset_of(const Text& text, const TextMetrics& m, const Box& ink, std::vector<std::string>& warnings) {
    const bool vertical = text.direction == "ttb" || text.direction == "btt";
    const std::string &h = text.halign, &v = text.valign;
    glm::dvec2 offset(0.0);
    if (h == "right") {
        offset.x = vertical ? -ink.hi.x : -m.advance.x;
    } else if (h == "center") {
        offset.x = vertical ? 0 : -m.advance.x / 2;
    } else if (h == "left") {
        offset.x = vertical ? -ink.lo.x : 0;
    } else if (h != "default") {
        offset.x = unknown("halign", R"("left", "right" or "center")", h, warnings);
    }
    if (v == "top") {
        offset.y = vertical ? 0 : -m.ascent;
    } else if (v == "center") {
        offset.y = vertical ? -m.advance.y / 2 : -(m.ascent + m.descent) / 2;
    } else if (v == "bottom") {
        offset.y = vertical ? -m.advance.y : -m.descent;
    } else if (v == "baseline" && vertical) {
        warnings.emplace_back("Don't use valign=\"baseline\" with vertical layouts");
    } else if (v != "default" && v != "baseline") {
        offset.y = unknown("valign", R"("baseline", "bottom", "top" or "center")", v, warnings);
    }
    return offset;
}

}  // namespace

std::optional<TextMetrics> text_metrics(const Text& text, FontLibrary& fonts, std::vector<std::string>& warnings) {
    const FT_Face face = sized_face(text, fonts, warnings);
    if (face == nullptr) {
        return std::nullopt;
    }
    const HbFont shaper(hb_ft_font_create(face, nullptr));
    TextMetrics m;
    Box ink;
    double ascent = std::numeric_limits<double>::lowest(), descent = std::numeric_limits<double>::max();
    for (const Glyph& glyph : shape(text, shaper.get())) {
        if (const Box box = ink_of(face, glyph.index); !box.empty()) {
            ascent = std::max(ascent, box.hi.y);
            descent = std::min(descent, box.lo.y);
            const glm::dvec3 at(m.advance + glyph.offset / kScale, 0.0);
            ink = enclose(ink, Box{box.lo + at, box.hi + at});
        }
        m.advance += glyph.advance / kScale * text.spacing;
    }
    if (!ink.empty()) {
        m.ascent = ascent * text.size;
        m.descent = descent * text.size;
        ink.lo *= text.size;
        ink.hi *= text.size;
    }
    m.advance *= text.size;
    if (!ink.empty()) {
        m.offset = offset_of(text, m, ink, warnings);
        m.position = m.offset + glm::dvec2(ink.lo);
        m.size = glm::dvec2(ink.hi) - glm::dvec2(ink.lo);
    }
    return m;
}

std::optional<FontMetrics> font_metrics(const Text& text, FontLibrary& fonts, std::vector<std::string>& warnings) {
    const FT_Face face = sized_face(text, fonts, warnings);
    if (face == nullptr) {
        return std::nullopt;
    }
    const auto scaled = [&](FT_Long units) {
        return static_cast<double>(FT_MulFix(units, face->size->metrics.y_scale)) / kScale * text.size;
    };
    const auto string = [](const char* name) { return std::string(name != nullptr ? name : ""); };
    return FontMetrics{scaled(face->ascender),  scaled(face->descender), scaled(face->bbox.yMax),
                       scaled(face->bbox.yMin), scaled(face->height),    string(face->family_name),
                       string(face->style_name)};
}

}  // namespace csg::solid
