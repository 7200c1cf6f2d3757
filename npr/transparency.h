// Models of transparency: what is seen through parts that are not opaque.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "npr/parameter.h"

namespace npr {

struct StyleInfo;

/// In shaders `transparency`.
enum class Transparency : int {
    Exact = 0,   ///< Faces: all layers blended front to back, Porter and Duff's "over".
    Volume = 1,  ///< Bodies: homogeneous media, integrated along the ray (Barta and Kovács 2011).
    /// Illustration: the nearest face, opaque within it, clear far from its silhouettes (Diepstraten, Weiskopf and
    /// Ertl 2002).
    ViewDependent = 2,
    /// Some samples of a face are opaque, the others are not there (object-space screen doors).
    ScreenDoor = 3,
    /// Triangles of the mesh, blended one after the other, back to front.
    Sorted = 4,
};

/// What is known of a model; docs/transparency/ has a page for each.
struct TransparencyInfo {
    Transparency model{};
    std::string_view name;   ///< For the command line.
    std::string_view label;  ///< For the window.
    std::span<const Parameter> parameters{};
};

/// All models; the first is the default.
[[nodiscard]] std::span<const TransparencyInfo> transparencies();

/// Does a style draw what is seen through as the picture's model has it? The others have their own way to look inside,
/// or none.
[[nodiscard]] bool follows_transparency(const StyleInfo& style);

/// Null where there is no model of that name.
[[nodiscard]] const TransparencyInfo* find_transparency(std::string_view name);

/// What a part is made of, where its color and opacity are not to say it.
struct PartMedium {
    std::string part;                  ///< Names of parts, as names_part() has them.
    std::optional<float> attenuation;  ///< Per millimeter, 0 or more.
    std::optional<glm::vec3> albedo;   ///< sRGB: the share of the light lost that is scattered to the eye.

    bool operator==(const PartMedium&) const = default;
};

/// Light in media, where 1 is the light by which a medium shows its albedo.
struct MediumLight {
    float ambient = 0.5F;      ///< From everywhere.
    float directional = 0.5F;  ///< From the light of surfaces, by Rayleigh's phase function, whose mean is 1.

    bool operator==(const MediumLight&) const = default;
};

/// In `volume` a body of this thickness has the opacity of its color, unless something else is asked for: a share of
/// the scene's diagonal.
inline constexpr float kMediumThickness = 0.1F;

}  // namespace npr
