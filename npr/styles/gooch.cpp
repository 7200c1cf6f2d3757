// Technical illustration (Gooch et al. 1998; Nienhaus 2005, listing 3-2 and 4.6).
#include "npr/styles/two_inks.h"

namespace npr {
namespace {

struct Settings : LinedSettings {
    glm::vec3 cool_color{};
    glm::vec3 warm_color{};
    float diffuse_cool{};  ///< Share of the surface's color.
    float diffuse_warm{};
    float specular{};
    glm::vec3 inner_color{};
    glm::vec3 profile_color{};

    void complete(const Picture& picture) {
        visible_only = true;
        complete_lines(picture);
    }
    static const SettingsTable<Settings>& table();
};

const SettingsTable<Settings>& Settings::table() {
    static const SettingsTable<Settings> all{
        setting<&Settings::width>(line_width(1.5F)),
        setting<&Settings::crease_degrees>(crease_angle()),
        setting<&Settings::parts>(part_edges()),
        setting<&Settings::cool_color>(Parameter::color("cool", "Cool color, away from the light", {0, 0, 0.55F})),
        setting<&Settings::warm_color>(Parameter::color("warm", "Warm color, toward the light", {0.3F, 0.3F, 0})),
        setting<&Settings::diffuse_cool>(Parameter::number("cool-color", "Surface color in the cool", 0.35F, 0, 1)),
        setting<&Settings::diffuse_warm>(Parameter::number("warm-color", "Surface color in the warm", 0.65F, 0, 1)),
        setting<&Settings::specular>(Parameter::number("specular", "Strength of the highlight", 0.6F, 0, 1)),
        setting<&Settings::inner_width>(),
        setting<&Settings::inner_strength>(Parameter::number("inner", "Strength of inner edges", 0.9F, 0, 1)),
        setting<&Settings::inner_color>(Parameter::color("inner-color", "Color of inner edges", {1, 1, 1})),
        setting<&Settings::profile_color>(Parameter::color("profile-color", "Color of profile edges", {0, 0, 0})),
    };
    return all;
}

using namespace glm;  // As shader files do.

struct GoochPixels : TwoInksFrame, Settings {
    GoochPixels(const CpuFrame& frame, const CpuEdges& edges, const Settings& s)
        : TwoInksFrame(frame, edges, s), Settings(s) {}
#include "npr/styles/gooch.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return gooch(p);
    }
    /// Highlights change from pixel to pixel wherever there is a surface.
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return surface_ids(p, 0).x == kNoSurface && LinedFrame::as_left(p);
    }
};

}  // namespace

StyleInfo gooch_style() {
    return lined_style<Settings, GoochPixels>({"gooch", "Technical (Gooch)", "npr/styles/gooch.frag"});
}

}  // namespace npr
