#include "csg/solid/fonts.h"

#include <algorithm>
#include <cstdlib>

namespace csg::solid {
namespace {

using Pattern = std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>>;

std::string string_of(FcPattern* pattern, const char* key) {
    FcChar8* text = nullptr;
    return FcPatternGetString(pattern, key, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace

FontLibrary::Impl::Impl() : config(FcInitLoadConfigAndFonts()) {
    FT_Init_FreeType(&freetype);
    const char* folders = std::getenv("OPENSCAD_FONT_PATH");
    std::string_view rest = folders != nullptr ? folders : "";
    while (!rest.empty()) {
        const std::string folder(rest.substr(0, rest.find(':')));
        FcConfigAppFontAddDir(config, reinterpret_cast<const FcChar8*>(folder.c_str()));
        rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
    }
}

FontLibrary::Impl::~Impl() {
    for (auto& [key, font] : fonts) {
        font.shaper.reset();
        if (font.face != nullptr) {
            FT_Done_Face(font.face);
        }
    }
    FT_Done_FreeType(freetype);
    FcConfigDestroy(config);
}

const Font* FontLibrary::Impl::find(const Text& text) {
    for (const std::string& file : text.font_files) {
        if (added.insert(file).second) {
            FcConfigAppFontAddFile(config, reinterpret_cast<const FcChar8*>(file.c_str()));
        }
    }
    const std::string name = text.font.empty() ? "Liberation Sans:style=Regular" : text.font;
    const Pattern wanted(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())));
    if (!wanted) {
        return nullptr;
    }
    FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const Pattern match(FcFontMatch(config, wanted.get(), &result));
    if (!match) {
        return nullptr;
    }
    int index = 0;
    FcPatternGetInteger(match.get(), FC_INDEX, 0, &index);
    return open(string_of(match.get(), FC_FILE), index);
}

const Font* FontLibrary::Impl::open(const std::string& path, int index) {
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

FontLibrary::FontLibrary() = default;
FontLibrary::~FontLibrary() = default;

FontLibrary::Impl& FontLibrary::impl() {
    if (!impl_) {
        impl_ = std::make_unique<Impl>();
    }
    return *impl_;
}

std::vector<Glyph> shape(const Text& text, hb_font_t* shaper) {
    const HbBuffer buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.text.data(), static_cast<int>(text.text.size()), 0, -1);
    hb_buffer_set_direction(buffer.get(), hb_direction_from_string(text.direction.c_str(), -1));
    if (!text.script.empty()) {
        hb_buffer_set_script(buffer.get(), hb_script_from_string(text.script.c_str(), -1));
    }
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
            if (hb_feature_from_string(list.data() + from, static_cast<int>(to - from), &feature) != 0) {
                features.push_back(feature);
            }
            from = to + 1;
        }
    }
    hb_shape(shaper, buffer.get(), features.data(), static_cast<unsigned>(features.size()));
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
    std::vector<Glyph> glyphs;
    for (unsigned i = 0; i < count; ++i) {
        glyphs.push_back({{positions[i].x_offset, positions[i].y_offset},
                          {positions[i].x_advance, positions[i].y_advance},
                          infos[i].codepoint});
    }
    return glyphs;
}

}  // namespace csg::solid
