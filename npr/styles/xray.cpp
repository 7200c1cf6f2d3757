// All layers, translucent, with their edges (Nienhaus 2005, 5.3).
#include "npr/smooth_shading.h"
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : LinedSettings {
    float opacity{};  ///< Of a layer that faces the eye.
    float rim{};
    float falloff{};
    float cue{};
    int colors{};       ///< 0: of the model, 1: by layer, 2: none.
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
        setting<&Settings::opacity>(Parameter::number("opacity", "Opacity of a layer", 0.16F, 0, 1)),
        setting<&Settings::rim>(Parameter::number("rim", "Opacity at outlines", 0.8F, 0, 2)),
        setting<&Settings::profile_strength>(Parameter::number("edges", "Strength of profile edges", 0.9F, 0, 1)),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 0.7F, 0, 1)),
        setting<&Settings::falloff>(Parameter::number("falloff", "Fading of edges from layer to layer", 0.93F, 0, 1)),
        setting<&Settings::cue>(Parameter::number("cue", "Fading of what is far", 0.45F, 0, 1)),
        setting<&Settings::colors>(Parameter::choice("colors", "Colors of", 0, {"model", "layers", "none"})),
        setting<&Settings::most_layers>(first_layers()),
        setting<&Settings::dashes>(line_dashes()),
        setting<&Settings::inner_share>(inner_line_width()),
        setting<&Settings::hidden_share>(hidden_line_width()),
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

struct XrayPixels : ShadedPixels<Settings> {
    using ShadedPixels::ShadedPixels;
#include "npr/styles/xray.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return xray(p);
    }
};

}  // namespace

StyleInfo xray_style() {
    return lined_style<Settings, XrayPixels>({"xray", "X-ray", "npr/styles/xray.frag"});
}

}  // namespace npr
