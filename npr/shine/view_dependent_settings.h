// Parameters of view-dependent transparency (docs/transparency/view-dependent.md).
#pragma once

#include "npr/settings.h"

namespace npr {

/// Up to where opaque parts show through the nearest face (Diepstraten, Weiskopf and Ertl 2002, sections 6.1 and 6.2).
enum class ShineMethod : int {
    BackFace = 0,   ///< I, inner boundaries not modeled: up to the first back face of what is seen through.
    FrontFace = 1,  ///< II, inner walls modeled: up to the second front face.
};

/// Where opacity is reckoned.
enum class ShineOpacity : int {
    Pixels = 0,    ///< By distances in the picture, exactly.
    Vertices = 1,  ///< By distances in the world, of the mesh's vertices, and between them in proportion.
};

struct ViewDependentSettings {
    int method{};              ///< A ShineMethod.
    float falloff{};           ///< k in opacity = 1 - (distance to silhouettes / size of the part)^k.
    float background{};        ///< So much of the background shows where the surface is clear.
    float opaque{};            ///< So much of opaque parts.
    bool gooch{};              ///< Cool to warm, or as the style shades.
    float silhouette_width{};  ///< Pixels; 0: none.
    int opacity{};             ///< A ShineOpacity.

    static const SettingsTable<ViewDependentSettings>& table();
};

/// Does the picture need the mesh of what is seen through?
[[nodiscard]] bool shines_by_vertex(const Picture& picture);

}  // namespace npr
