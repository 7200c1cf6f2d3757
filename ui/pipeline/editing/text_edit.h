// Changes of a text, byte by byte.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "csg/scad/source/source.h"

namespace ui {

struct TextEdit {
    csg::scad::ByteRange bytes;  ///< Replaced; empty where something is put in.
    std::string text;
};

/// The text after edits that do not overlap, in any order.
[[nodiscard]] std::string edited(const std::string& text, std::vector<TextEdit> edits);

/// The shortest decimal text of a number within `tolerance` of `value`.
[[nodiscard]] std::string short_number(double value, double tolerance);
/// "[1, 2.5, 0]", each number so.
[[nodiscard]] std::string short_vector(const glm::dvec3& v, double tolerance);

}  // namespace ui
