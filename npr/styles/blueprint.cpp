// Edges of all layers, like light through paper.
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : LinedSettings {
    float hidden_strength{};  ///< Of the second layer's edges.
    float hidden_falloff{};   ///< From layer to layer.
    float tone{};             ///< Of one layer.
    int most_layers{};        ///< 0: all.
    bool grid{};
    float grid_spacing{};
    int ground{};  ///< 0: blue, 1: white.
    glm::vec3 ground_color{};
    glm::vec3 line_color{};
    glm::vec3 wash_color{};

    void complete(const Picture& picture) {
        const glm::vec3 blue = glm::vec3(0x1b, 0x3f, 0x8b) / 255.0F, white = glm::vec3(0xf6, 0xf8, 0xfc) / 255.0F;
        complete_lines(picture);
        ground_color = ground == 0 ? blue : white;
        line_color = ground == 0 ? white : blue;
        wash_color = glm::vec3(0x5b, 0x97, 0xf2) / 255.0F;
    }
    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.8F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 1, 0, 1)),
        setting<&Settings::ground>(Parameter::choice("ground", "Ground", 0, {"blue", "white"})),
        setting<&Settings::hidden_strength>(Parameter::number("hidden", "Strength of hidden edges", 0.65F, 0, 1)),
        setting<&Settings::hidden_falloff>(Parameter::number("falloff", "Fading from layer to layer", 0.75F, 0, 1)),
        setting<&Settings::tone>(Parameter::number("tone", "Tone of a layer", 0.07F, 0, 0.25F)),
        setting<&Settings::most_layers>(first_layers()),
        setting<&Settings::grid>(Parameter::toggle("grid", "Grid on the paper", false)),
        setting<&Settings::grid_spacing>(Parameter::integer("grid-spacing", "Spacing of the grid", 16, 4, 128)),
        setting<&Settings::dashes>(line_dashes()),
        setting<&Settings::inner_share>(inner_line_width()),
        setting<&Settings::hidden_share>(hidden_line_width()),
        setting<&Settings::inner_width>(),
        setting<&Settings::hidden_width>(),
        setting<&Settings::ground_color>(),
        setting<&Settings::line_color>(),
        setting<&Settings::wash_color>(),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct BlueprintPixels : LinedPixels<Settings> {
    using LinedPixels::LinedPixels;
#include "npr/styles/blueprint.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return blueprint(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return !grid && LinedFrame::as_left(p);
    }
};

}  // namespace

StyleInfo blueprint_style() {
    return lined_style<Settings, BlueprintPixels>({"blueprint", "Blueprint", "npr/styles/blueprint.frag"});
}

}  // namespace npr
