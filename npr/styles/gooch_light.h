// The settings of npr/styles/gooch_light.glsl.
#pragma once

#include <glm/glm.hpp>

#include "npr/parameter.h"

namespace npr {

struct GoochLight {
    glm::vec3 cool_color{};
    glm::vec3 warm_color{};
    float diffuse_cool{};  ///< Share of the surface's color.
    float diffuse_warm{};
    float specular{};
};

// The parameter of each.
[[nodiscard]] inline Parameter gooch_cool() {
    return Parameter::color("cool", "Cool color, away from the light", {0, 0, 0.55F});
}
[[nodiscard]] inline Parameter gooch_warm() {
    return Parameter::color("warm", "Warm color, toward the light", {0.3F, 0.3F, 0});
}
[[nodiscard]] inline Parameter gooch_cool_share() {
    return Parameter::number("cool-color", "Surface color in the cool", 0.35F, 0, 1);
}
[[nodiscard]] inline Parameter gooch_warm_share() {
    return Parameter::number("warm-color", "Surface color in the warm", 0.65F, 0, 1);
}
[[nodiscard]] inline Parameter gooch_specular(float initial) {
    return Parameter::number("specular", "Strength of the highlight", initial, 0, 1);
}

}  // namespace npr
