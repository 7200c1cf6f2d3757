// Few tones (Nienhaus 2005, 4.6).
#include "npr/cast_shadows.h"
#include "npr/smooth_shading.h"
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : VisibleLines {
    int steps{};
    float shadow{};  ///< The darkest tone, as a share of the surface's color.
    float cue{};     ///< How much less saturated the far end is.
    glm::vec3 edge_color{};
    bool smooth_shading{};
    bool cast_shadows{};

    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.8F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::inner_width>(),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 0.8F, 0, 1)),
        setting<&Settings::steps>(Parameter::integer("steps", "Tones", 4, 2, 8)),
        setting<&Settings::shadow>(Parameter::number("shadow", "Lightness of the darkest tone", 0.55F, 0, 1)),
        setting<&Settings::cue>(Parameter::number("cue", "Less saturation of what is far", 0.8F, 0, 1)),
        setting<&Settings::edge_color>(Parameter::color("edge-color", "Color of edges", {0.08F, 0.07F, 0.07F})),
        setting<&Settings::smooth_shading>(smooth_surfaces()),
        setting<&Settings::cast_shadows>(shadows_cast(true)),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct NtonePixels : ShadedPixels<Settings> {
    using ShadedPixels::ShadedPixels;
#include "npr/styles/ntone.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return ntone(p);
    }
};

}  // namespace

StyleInfo ntone_style() {
    return lined_style<Settings, NtonePixels>({"ntone", "n-tone", "npr/styles/ntone.frag"});
}

}  // namespace npr
