// Text as outlines, by fontconfig, HarfBuzz and FreeType.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/solid/outline.h"
#include "csg/tree/text_metrics.h"

namespace csg::solid {

/// The fonts of the machine, of the folders in OPENSCAD_FONT_PATH and of `use <font.ttf>`; opened when they are first
/// asked for. Not for several threads at a time.
class FontLibrary {
  public:
    FontLibrary();
    ~FontLibrary();
    FontLibrary(const FontLibrary&) = delete;
    FontLibrary& operator=(const FontLibrary&) = delete;

    struct Impl;
    /// For csg/solid (fonts.h).
    [[nodiscard]] Impl& impl();

  private:
    std::unique_ptr<Impl> impl_;
};

/// OpenSCAD's text(): a size of 10 gives capitals about 10 high, the baseline is y = 0. Throws GeometryError where
/// there is no font, or too much text.
[[nodiscard]] Outline text_outline(const Text& text, FontLibrary& fonts);

/// OpenSCAD's textmetrics(), whose figures are those of the font at a size of 1000 points, hinted and on whole pixels,
/// scaled down. Nothing where there is no font.
[[nodiscard]] std::optional<TextMetrics> text_metrics(const Text& text, FontLibrary& fonts,
                                                      std::vector<std::string>& warnings);

/// OpenSCAD's fontmetrics(), of the font and size of a text.
[[nodiscard]] std::optional<FontMetrics> font_metrics(const Text& text, FontLibrary& fonts,
                                                      std::vector<std::string>& warnings);

}  // namespace csg::solid
