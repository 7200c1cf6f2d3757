// Text as outlines in the plane, several lines of it.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/outline.h"
#include "csg/solid/text_outline.h"

namespace ui {

/// From (0, 0) to `size`, the lines from above; capitals are as high as was asked for.
struct TextShape {
    csg::solid::Outline outline;
    glm::dvec2 size{0.0};
};

/// Lines are told apart by line feeds. Throws csg::solid::GeometryError where there is no font.
[[nodiscard]] TextShape text_shape(const std::string& text, double capitals, csg::solid::FontLibrary& fonts);

/// With line feeds in place of blanks, so that no line has more characters than that, but for words that have.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t characters);

}  // namespace ui
