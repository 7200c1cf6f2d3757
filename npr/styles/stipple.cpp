// Stippling.
#include "npr/smooth_shading.h"
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : VisibleLines {
    float spacing{};  ///< Pixels between two dots, about.
    float darkest{};
    float wash{};
    glm::uint seed{};
    glm::vec3 ink_color{};
    glm::vec3 paper_color{};
    bool smooth_shading{};

    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.8F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::inner_width>(),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 1, 0, 1)),
        setting<&Settings::spacing>(Parameter::number("spacing", "Distance of dots", 3.5F, 2, 32)),
        setting<&Settings::darkest>(Parameter::number("tone", "Share of ink, at most", 0.65F, 0, 1)),
        setting<&Settings::wash>(Parameter::number("color", "Strength of surface colors", 0, 0, 1)),
        setting<&Settings::seed>(Parameter::integer("seed", "Seed", 1, 0, 9999)),
        setting<&Settings::ink_color>(Parameter::color("ink", "Color of strokes", {0.1F, 0.09F, 0.09F})),
        setting<&Settings::paper_color>(Parameter::color("paper", "Color of the paper", {1, 1, 1})),
        setting<&Settings::smooth_shading>(smooth_surfaces()),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct StipplePixels : ShadedPixels<Settings> {
    using ShadedPixels::ShadedPixels;
#include "npr/styles/noise.glsl"
#include "npr/styles/surface_place.glsl"

#include "npr/styles/stipple.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return ink_on_paper(p);
    }
};

}  // namespace

StyleInfo stipple_style() {
    return lined_style<Settings, StipplePixels>({"stipple", "Stippling", "npr/styles/stipple.frag"});
}

}  // namespace npr
