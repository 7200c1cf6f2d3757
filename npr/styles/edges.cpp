// Surface colors with edges drawn.
#include "npr/smooth_shading.h"
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : LinedSettings {
    glm::vec3 edge_color{};
    float shade{};           ///< 0: paper, 1: surface colors.
    float light_strength{};  ///< 0: as they are, 1: lit.
    bool smooth_lines{};
    bool smooth_shading{};

    void complete(const Picture& picture) {
        visible_only = true;
        hard = !smooth_lines;
        follow_borders = smooth_lines;
        complete_lines(picture);
    }
    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.8F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 0.85F, 0, 1)),
        setting<&Settings::edge_color>(Parameter::color("edge-color", "Color of edges", {0.12F, 0.11F, 0.10F})),
        setting<&Settings::shade>(Parameter::number("shade", "Strength of surface colors", 1, 0, 1)),
        setting<&Settings::light_strength>(Parameter::number("light", "Strength of light on surfaces", 1, 0, 1)),
        setting<&Settings::smooth_lines>(Parameter::toggle("smooth", "Smooth lines", true)),
        setting<&Settings::inner_share>(inner_line_width()),
        setting<&Settings::smooth_shading>(smooth_surfaces("smooth-surfaces", false)),
        setting<&Settings::inner_width>(),
        setting<&Settings::section_share>(section_line_width()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct EdgesPixels : LinedPixels<Settings> {
    using LinedPixels::LinedPixels;
#include "npr/styles/edges.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return edges(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return LinedPixels::as_left(p) && !(smooth_shading && sees_curves(p));
    }
};

}  // namespace

StyleInfo edges_style() {
    return lined_style<Settings, EdgesPixels>({"edges", "Edges", "npr/styles/edges.frag"});
}

}  // namespace npr
