// Line drawings: hidden lines removed.
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

struct Settings : VisibleLines {
    glm::vec3 ink_color{};
    glm::vec3 paper_color{};

    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.8F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::inner_width>(),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 1, 0, 1)),
        setting<&Settings::ink_color>(Parameter::color("ink", "Color of lines", {0, 0, 0})),
        setting<&Settings::paper_color>(Parameter::color("paper", "Color of the paper", {1, 1, 1})),
        setting<&Settings::section_share>(section_line_width()),
        setting<&Settings::halo>(line_halo()),
        setting<&Settings::taper>(line_taper()),
        setting<&Settings::taper_ends>(line_taper_ends()),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct LinesPixels : LinedPixels<Settings> {
    using LinedPixels::LinedPixels;
#include "npr/styles/lines.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return line_drawing(p);
    }
};

}  // namespace

StyleInfo lines_style() {
    return lined_style<Settings, LinesPixels>({"lines", "Lines", "npr/styles/lines.frag"});
}

}  // namespace npr
