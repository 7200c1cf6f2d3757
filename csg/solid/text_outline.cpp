#include "csg/solid/text_outline.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include <fmt/format.h>
#include <hb.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "csg/solid/solid.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostBytes = 1 << 16;
/// Model units per em for a size of 1: OpenSCAD sets type in points at 100 dots per inch.
constexpr double kEmPerSize = 100.0 / 72.0;

template <auto kDestroy>
struct Destroy {
    template <typename T>
    void operator()(T* object) const {
        kDestroy(object);
    }
};

using Pattern = std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>>;
using HbFont = std::unique_ptr<hb_font_t, Destroy<hb_font_destroy>>;
using HbFace = std::unique_ptr<hb_face_t, Destroy<hb_face_destroy>>;
using HbBlob = std::unique_ptr<hb_blob_t, Destroy<hb_blob_destroy>>;
using HbBuffer = std::unique_ptr<hb_buffer_t, Destroy<hb_buffer_destroy>>;

struct Font {
    FT_Face face = nullptr;
    HbFont shaper;
    double units = 1000;  ///< Per em.
};

std::string string_of(FcPattern* pattern, const char* key) {
    FcChar8* text = nullptr;
    return FcPatternGetString(pattern, key, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

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

struct Glyph {
    glm::dvec2 offset, advance;  ///< Font units.
    std::uint32_t index;
};

/// In a font that has no metrics for vertical text every letter stands in the middle of a line's height, which is
/// FreeType's (and so OpenSCAD's) and not HarfBuzz's.
void set_below_each_other(const Font& font, std::vector<Glyph>& glyphs) {
    const auto* os2 = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(font.face, FT_SFNT_OS2));
    if (FT_HAS_VERTICAL(font.face) || os2 == nullptr || os2->version == 0xFFFF)
        return;
    const int line = os2->sTypoAscender - os2->sTypoDescender;
    for (Glyph& glyph : glyphs) {
        hb_position_t x = 0, y = 0;
        hb_font_get_glyph_v_origin(font.shaper.get(), glyph.index, &x, &y);
        hb_glyph_extents_t box{};
        hb_font_get_glyph_extents(font.shaper.get(), glyph.index, &box);
        glyph.offset.y += y - (box.y_bearing + (line + box.height) / 2);
        glyph.advance.y -= line + hb_font_get_glyph_v_advance(font.shaper.get(), glyph.index);
    }
}

std::vector<Glyph> shape(const Text& text, const Font& font) {
    const HbBuffer buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.text.data(), static_cast<int>(text.text.size()), 0, -1);
    hb_buffer_set_direction(buffer.get(), hb_direction_from_string(text.direction.c_str(), -1));
    if (!text.script.empty())
        hb_buffer_set_script(buffer.get(), hb_script_from_string(text.script.c_str(), -1));
    hb_buffer_set_language(buffer.get(), hb_language_from_string(text.language.c_str(), -1));
    hb_buffer_guess_segment_properties(buffer.get());
    // `fontfeatures=+liga;-kern` of the font's name.
    std::vector<hb_feature_t> features;
    if (const std::size_t begin = text.font.find("fontfeatures="); begin != std::string::npos) {
        std::string list = text.font.substr(begin + 13);
        list.resize(std::min(list.size(), list.find(':')));
        for (std::size_t from = 0; from < list.size();) {
            const std::size_t to = std::min(list.find(';', from), list.size());
            hb_feature_t feature;
            if (hb_feature_from_string(list.data() + from, static_cast<int>(to - from), &feature) != 0)
                features.push_back(feature);
            from = to + 1;
        }
    }
    hb_shape(font.shaper.get(), buffer.get(), features.data(), static_cast<unsigned>(features.size()));
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
    std::vector<Glyph> glyphs;
    for (unsigned i = 0; i < count; ++i) {
        glyphs.push_back({{positions[i].x_offset, positions[i].y_offset},
                          {positions[i].x_advance, positions[i].y_advance},
                          infos[i].codepoint});
    }
    if (HB_DIRECTION_IS_VERTICAL(hb_buffer_get_direction(buffer.get())))
        set_below_each_other(font, glyphs);
    return glyphs;
}

/// Where the text's origin is, so that it stands as asked: extents in font units.
glm::dvec2 alignment(const Text& text, const glm::dvec2& advance, const Box& box) {
    const bool vertical = text.direction == "ttb" || text.direction == "btt";
    glm::dvec2 shift(0.0);
    if (text.halign == "center")
        shift.x = vertical ? 0 : -advance.x / 2;
    else if (text.halign == "right")
        shift.x = vertical ? -box.hi.x : -advance.x;
    else if (text.halign == "left" && vertical)
        shift.x = -box.lo.x;
    if (box.empty())
        return shift;
    if (text.valign == "top")
        shift.y = vertical ? 0 : -box.hi.y;
    else if (text.valign == "center")
        shift.y = vertical ? -advance.y / 2 : -(box.lo.y + box.hi.y) / 2;
    else if (text.valign == "bottom")
        shift.y = vertical ? -advance.y : -box.lo.y;
    return shift;
}

}  // namespace

struct FontLibrary::Impl {
    Impl() : config(FcInitLoadConfigAndFonts()) {
        FT_Init_FreeType(&freetype);
        const char* folders = std::getenv("OPENSCAD_FONT_PATH");
        std::string_view rest = folders != nullptr ? folders : "";
        while (!rest.empty()) {
            const std::string folder(rest.substr(0, rest.find(':')));
            FcConfigAppFontAddDir(config, reinterpret_cast<const FcChar8*>(folder.c_str()));
            rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
        }
    }
    ~Impl() {
        for (auto& [key, font] : fonts) {
            font.shaper.reset();
            if (font.face != nullptr)
                FT_Done_Face(font.face);
        }
        FT_Done_FreeType(freetype);
        FcConfigDestroy(config);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// Null where there is none at all.
    const Font* find(const Text& text) {
        for (const std::string& file : text.font_files) {
            if (added.insert(file).second)
                FcConfigAppFontAddFile(config, reinterpret_cast<const FcChar8*>(file.c_str()));
        }
        const std::string name = text.font.empty() ? "Liberation Sans:style=Regular" : text.font;
        const Pattern wanted(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())));
        if (!wanted)
            return nullptr;
        FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
        FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
        FcDefaultSubstitute(wanted.get());
        FcResult result = FcResultNoMatch;
        const Pattern match(FcFontMatch(config, wanted.get(), &result));
        if (!match)
            return nullptr;
        int index = 0;
        FcPatternGetInteger(match.get(), FC_INDEX, 0, &index);
        return open(string_of(match.get(), FC_FILE), index);
    }

    const Font* open(const std::string& path, int index) {
        const auto [entry, is_new] = fonts.try_emplace({path, index});
        Font& font = entry->second;
        if (is_new && FT_New_Face(freetype, path.c_str(), index, &font.face) == 0) {
            const HbBlob blob(hb_blob_create_from_file(path.c_str()));
            const HbFace face(hb_face_create(blob.get(), static_cast<unsigned>(index)));
            font.shaper.reset(hb_font_create(face.get()));
            font.units = std::max(1U, hb_face_get_upem(face.get()));
        }
        return font.face != nullptr ? &font : nullptr;
    }

    FcConfig* config;
    FT_Library freetype = nullptr;
    std::set<std::string> added;
    std::map<std::pair<std::string, int>, Font> fonts;
};

FontLibrary::FontLibrary() = default;
FontLibrary::~FontLibrary() = default;

Outline text_outline(const Text& text, FontLibrary& fonts, std::vector<std::string>& warnings) {
    if (text.text.empty() || !(text.size > 0) || !std::isfinite(text.size) || !std::isfinite(text.spacing))
        return {};
    if (text.text.size() > kMostBytes) {
        warnings.push_back(fmt::format("text() is longer than {} bytes; it is left out", kMostBytes));
        return {};
    }
    if (!fonts.impl_)
        fonts.impl_ = std::make_unique<FontLibrary::Impl>();
    const Font* font = fonts.impl_->find(text);
    if (font == nullptr) {
        warnings.push_back(fmt::format("Can't get font {}", text.font));
        return {};
    }
    const int around = circle_segments(text.size, text.fineness);
    const unsigned segments = static_cast<unsigned>(std::max(around / 8 + 1, 2));
    glm::dvec2 pen(0.0);
    std::vector<std::shared_ptr<const Outline>> letters;
    Box box;
    for (const Glyph& glyph : shape(text, *font)) {
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
