// Fonts as FreeType and HarfBuzz hold them. Internal to csg/solid: text_outline.h is what others use.
#pragma once

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "csg/solid/text_outline.h"

namespace csg::solid {

/// Model units per em for a size of 1: OpenSCAD sets type in points at 100 dots per inch.
inline constexpr double kEmPerSize = 100.0 / 72.0;

template <auto kDestroy>
struct Destroy {
    template <typename T>
    void operator()(T* object) const {
        kDestroy(object);
    }
};

using HbFont = std::unique_ptr<hb_font_t, Destroy<hb_font_destroy>>;
using HbFace = std::unique_ptr<hb_face_t, Destroy<hb_face_destroy>>;
using HbBlob = std::unique_ptr<hb_blob_t, Destroy<hb_blob_destroy>>;
using HbBuffer = std::unique_ptr<hb_buffer_t, Destroy<hb_buffer_destroy>>;

struct Font {
    FT_Face face = nullptr;
    HbFont shaper;
    double units = 1000;  ///< Per em.
};

/// What FontLibrary hides.
struct FontLibrary::Impl {
    Impl();
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// The font that a text asks for, or the nearest there is; null where there is none at all.
    const Font* find(const Text& text);
    const Font* open(const std::string& path, int index);

    FcConfig* config;
    FT_Library freetype = nullptr;
    std::set<std::string> added;
    std::map<std::pair<std::string, int>, Font> fonts;
};

struct Glyph {
    glm::dvec2 offset, advance;  ///< In the units of the shaper.
    std::uint32_t index;
};

/// The glyphs of a text in their order, in the units of `shaper`.
[[nodiscard]] std::vector<Glyph> shape(const Text& text, hb_font_t* shaper);

}  // namespace csg::solid
