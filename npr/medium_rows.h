// The media of a picture's parts, as the shaders read them.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "layers/surface_table.h"
#include "npr/picture.h"

namespace npr {

/// Albedo times attenuation (red, green, blue), and attenuation: `high` * kMediumHalf + `low` units (peel/media.glsl).
struct MediumRow {
    glm::ivec4 high{0}, low{0};
    glm::ivec4 is_medium{0};  ///< In x, 0 or 1.
};

struct MediumTable {
    std::vector<MediumRow> rows;  ///< By part, at least one; zero for what is no medium.
    float unit = 0;               ///< Per millimeter.
};

/// Attenuation per millimeter of what has this opacity at a thickness of `thickness` millimeters.
[[nodiscard]] double attenuation_of(double opacity, double thickness);

/// Media are the parts that are translucent, by color and opacity (see kMediumThickness), and those that the picture
/// says something of.
/// `diagonal`: the scene's, in millimeters. None are, where the picture's model of transparency is not Volume.
[[nodiscard]] MediumTable media_of(const Picture& picture, std::span<const layers::PartLook> parts, double diagonal);

}  // namespace npr
