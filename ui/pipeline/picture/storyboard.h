// Panels with captions on one sheet: a motion in key frames (Nienhaus 2005, section 7.1).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/image.h"
#include "csg/solid/text_outline.h"
#include "npr/color_scheme.h"

namespace ui {

/// Where panels are on a sheet: pixels from its upper left corner.
struct SheetLayout {
    glm::ivec2 panel{0};  ///< The size of each.
    int caption = 0;      ///< Height of the strip below each.
    std::vector<glm::ivec2> corners;
};

/// `count` panels in rows, as large as they can be where each is about as wide as `aspect` times its height. Throws
/// std::runtime_error where they would be smaller than 32 pixels.
[[nodiscard]] SheetLayout sheet_layout(glm::ivec2 size, int count, double aspect = 4.0 / 3);

/// The sheet; `render(i)` draws panel i, of the layout's size. Panels have a line about them.
[[nodiscard]] base::Image draw_sheet(glm::ivec2 size, const SheetLayout& layout,
                                     const std::vector<std::string>& captions, const npr::ColorScheme& scheme,
                                     const std::function<base::Image(std::size_t)>& render);

/// Writes a line of text into an image: `corner` is the left end of its baseline, pixels from the upper left corner;
/// capitals are so high. Throws csg::solid::GeometryError where there is no font. Gives its width.
double draw_text(base::Image& image, const std::string& text, const glm::dvec2& corner, double capitals,
                 const glm::vec3& color, csg::solid::FontLibrary& fonts);

}  // namespace ui
