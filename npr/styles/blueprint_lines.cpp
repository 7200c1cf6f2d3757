// The edges of all layers as equal lines (Nienhaus 2005, 5.2).
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : LinedSettings {
    float threshold{};       ///< Of the intensity of edges.
    float hidden_falloff{};  ///< Of intensities, from layer to layer.
    int most_layers{};       ///< 0: all.
    glm::vec3 ink_color{};
    glm::vec3 paper_color{};

    void complete(const Picture& picture) { complete_lines(picture); }
    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.6F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::threshold>(
            Parameter::number("threshold", "Intensity from which edges are drawn", 0.5F, 0, 1)),
        setting<&Settings::hidden_falloff>(Parameter::number("falloff", "Fading from layer to layer", 0.92F, 0, 1)),
        setting<&Settings::most_layers>(first_layers()),
        setting<&Settings::ink_color>(Parameter::color("ink", "Color of lines", {0.92F, 0.95F, 1})),
        setting<&Settings::paper_color>(Parameter::color("paper", "Color of the paper", {0.106F, 0.247F, 0.545F})),
        setting<&Settings::dashes>(line_dashes()),
        setting<&Settings::inner_share>(inner_line_width()),
        setting<&Settings::hidden_share>(hidden_line_width()),
        setting<&Settings::inner_width>(),
        setting<&Settings::hidden_width>(),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct BlueprintLinesPixels : LinedPixels<Settings> {
    using LinedPixels::LinedPixels;
#include "npr/styles/blueprint_lines.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return blueprint_lines(p);
    }
};

}  // namespace

StyleInfo blueprint_lines_style() {
    return lined_style<Settings, BlueprintLinesPixels>(
        {"blueprint-lines", "Blueprint of lines", "npr/styles/blueprint_lines.frag"});
}

}  // namespace npr
