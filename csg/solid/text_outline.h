// Text as outlines, by fontconfig, HarfBuzz and FreeType.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/solid/outline.h"

namespace csg::solid {

/// The fonts of the machine, of the folders in OPENSCAD_FONT_PATH and of `use <font.ttf>`; opened when they are first
/// asked for. Not for several threads at a time.
class FontLibrary {
  public:
    FontLibrary();
    ~FontLibrary();
    FontLibrary(const FontLibrary&) = delete;
    FontLibrary& operator=(const FontLibrary&) = delete;

  private:
    friend Outline text_outline(const Text& text, FontLibrary& fonts, std::vector<std::string>& warnings);
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// OpenSCAD's text(): a size of 10 gives capitals about 10 high, the baseline is y = 0.
[[nodiscard]] Outline text_outline(const Text& text, FontLibrary& fonts, std::vector<std::string>& warnings);

}  // namespace csg::solid
