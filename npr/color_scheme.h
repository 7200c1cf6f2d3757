// OpenSCAD's color schemes for its preview, by its names.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace npr {

/// Colors are sRGB in [0, 1]; where they have a fourth component it is straight alpha.
struct ColorScheme {
    std::string_view name;
    glm::vec3 background{1.0F};
    glm::vec3 background_stop{1.0F};  ///< Lower end of the background's gradient; equal where it has none.
    glm::vec3 face{1.0F};             ///< opencsg-face-front: faces of added leaves.
    glm::vec3 cut{1.0F};              ///< opencsg-face-back: faces of subtracted leaves.
    glm::vec3 face_2d{1.0F};          ///< cgal-face-2d: results in the plane, …
    glm::vec3 edge_2d{1.0F};          ///< cgal-edge-2d: … and their outlines.
    glm::vec4 highlight{1.0F};        ///< `#`; the same in all schemes.
    glm::vec4 ghost{1.0F};            ///< `%`; the same in all schemes.

    bool operator==(const ColorScheme&) const = default;
};

/// All schemes in OpenSCAD's order; the first is its default, Cornfield.
[[nodiscard]] std::span<const ColorScheme> color_schemes();

/// Null where there is no scheme of that name (compared exactly).
[[nodiscard]] const ColorScheme* find_color_scheme(std::string_view name);

}  // namespace npr
