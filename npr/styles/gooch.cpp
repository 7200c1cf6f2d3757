// Technical illustration (Gooch et al. 1998; Nienhaus 2005, listing 3-2 and 4.6).
#include "npr/cast_shadows.h"
#include "npr/smooth_shading.h"
#include "npr/styles/gooch_light.h"
#include "npr/styles/two_inks.h"

namespace npr {
namespace {

struct Settings : VisibleLines, GoochLight {
    glm::vec3 inner_color{};
    glm::vec3 profile_color{};
    bool smooth_shading{};
    bool cast_shadows{};

    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.5F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::cool_color>(gooch_cool()),
        setting<&Settings::warm_color>(gooch_warm()),
        setting<&Settings::diffuse_cool>(gooch_cool_share()),
        setting<&Settings::diffuse_warm>(gooch_warm_share()),
        setting<&Settings::specular>(gooch_specular(0.6F)),
        setting<&Settings::inner_width>(),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 0.9F, 0, 1)),
        setting<&Settings::inner_color>(Parameter::color("inner-color", "Color of inner edges", {1, 1, 1})),
        setting<&Settings::profile_color>(Parameter::color("profile-color", "Color of profile edges", {0, 0, 0})),
        setting<&Settings::smooth_shading>(smooth_surfaces()),
        setting<&Settings::cast_shadows>(shadows_cast(false)),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct GoochPixels : ShadedPixels<Settings, TwoInksFrame> {
    using ShadedPixels::ShadedPixels;
#include "npr/styles/gooch.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return gooch(p);
    }
};

}  // namespace

StyleInfo gooch_style() {
    return lined_style<Settings, GoochPixels>({"gooch", "Technical (Gooch)", "npr/styles/gooch.frag"});
}

}  // namespace npr
