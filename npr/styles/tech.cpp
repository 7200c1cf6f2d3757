// Technical illustration, seen through (Nienhaus 2005, 5.3).
#include "npr/smooth_shading.h"
#include "npr/styles/gooch_light.h"
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : LinedSettings, GoochLight {
    float opacity{};  ///< Of a layer.
    float falloff{};
    glm::vec3 edge_color{};
    int most_layers{};  ///< 0: all.
    bool smooth_shading{};

    void complete(const Picture& picture) { complete_lines(picture); }
    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.8F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::opacity>(Parameter::number("opacity", "Opacity of a layer", 0.3F, 0, 1)),
        setting<&Settings::cool_color>(gooch_cool()),
        setting<&Settings::warm_color>(gooch_warm()),
        setting<&Settings::diffuse_cool>(gooch_cool_share()),
        setting<&Settings::diffuse_warm>(gooch_warm_share()),
        setting<&Settings::specular>(gooch_specular(0.4F)),
        setting<&Settings::profile_strength>(Parameter::number("edges", "Strength of profile edges", 1, 0, 1)),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 0.8F, 0, 1)),
        setting<&Settings::falloff>(Parameter::number("falloff", "Fading of edges from layer to layer", 0.85F, 0, 1)),
        setting<&Settings::edge_color>(Parameter::color("edge-color", "Color of edges", {0.05F, 0.05F, 0.08F})),
        setting<&Settings::most_layers>(first_layers()),
        setting<&Settings::dashes>(line_dashes()),
        setting<&Settings::inner_width>(),
        setting<&Settings::hidden_width>(),
        setting<&Settings::smooth_shading>(smooth_surfaces()),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct TechPixels : ShadedPixels<Settings> {
    using ShadedPixels::ShadedPixels;
#include "npr/styles/tech.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return tech(p);
    }
};

}  // namespace

StyleInfo tech_style() {
    return lined_style<Settings, TechPixels>({"tech", "Technical, through", "npr/styles/tech.frag"});
}

}  // namespace npr
