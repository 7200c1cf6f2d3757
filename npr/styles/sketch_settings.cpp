#include "npr/styles/sketch_settings.h"

#include <algorithm>
#include <cmath>

#include "npr/smooth_shading.h"

namespace npr {

SettingsTable<SketchSettings> hand_table(const HandParameters& hand) {
    using S = SketchSettings;
    return {
        setting<&S::width>(line_width(hand.width)),
        setting<&S::crease_degrees>(crease_angle()),
        setting<&S::parts>(part_edges()),
        setting<&S::seed>(Parameter::integer("seed", "Seed", 1, 0, 9999)),
        setting<&S::wobble>(Parameter::number("wobble", "Deviation of strokes", hand.wobble, 0, 20)),
        setting<&S::strokes>(Parameter::integer("strokes", "Strokes per edge", hand.strokes, 1, 4)),
        setting<&S::overshoot_length>(
            Parameter::number("overshoot", "Length drawn beyond corners", hand.overshoot, 0, 60)),
        Setting<&S::medium>{hand.medium},
        Setting<&S::hatch>{hand.hatch},
        Setting<&S::wash>{hand.wash},
        Setting<&S::hidden>{hand.hidden},
        Setting<&S::hidden_falloff>{hand.hidden_falloff},
        Setting<&S::layer_tone>{hand.layer_tone},
        setting<&S::on_model>(Parameter::choice("anchor", "Noise anchored to", 1, {"picture", "model"})),
        setting<&S::ink_color>(Parameter::color("ink", "Color of strokes", hand.ink)),
        setting<&S::paper_color>(Parameter::color("paper", "Color of the paper", hand.paper)),
        Setting<&S::smooth_shading>{hand.smooth_shading},
        setting<&S::unit>(),
        setting<&S::hidden_width>(),
        setting<&S::inner_strength>(),
        setting<&S::hidden_inner>(),
        setting<&S::correlated>(),
    };
}

const SettingsTable<SketchSettings>& SketchSettings::table() {
    static const SettingsTable<SketchSettings> all = hand_table({
        .width = 1.4F,
        .wobble = 3,
        .strokes = 2,
        .overshoot = 16,
        .ink = {0.16F, 0.15F, 0.17F},
        .paper = {0.975F, 0.957F, 0.915F},
        .medium = Parameter::choice("medium", "Medium", 0, {"pencil", "ink", "chalk"}),
        .hatch = Parameter::number("hatch", "Strength of hatching", 0.75F, 0, 1),
        .wash = Parameter::number("color", "Strength of surface colors", 0.55F, 0, 1),
        .hidden = Parameter::number("hidden", "Strength of hidden edges", 0, 0, 1),
        .smooth_shading = smooth_surfaces(),
    });
    return all;
}

void SketchSettings::complete(const Picture& picture) {
    unit = static_cast<float>(picture.size.y - 2 * picture.guard) / 512.0F;
    width = width * std::sqrt(std::max(unit, 1.0F));
    hidden_width = 0.75F * width;
    inner_strength = 0.72F;
    hidden_inner = 0.8F;
    wobble = unit * wobble;
    overshoot_length = unit * overshoot_length;
    correlated = medium != 2;
    visible_only = hidden == 0.0F;
    hidden_falloff = hidden_falloff > 0 ? hidden_falloff : 1;
}

NoiseKey noise_key(const SketchSettings& settings, glm::ivec2 size, int guard) {
    return {size, guard, settings.seed, settings.correlated, settings.on_model};
}

Relief sketch_relief(const base::View& view, std::span<const float> depths, const SketchSettings& settings,
                     const glm::dvec3& center, double diagonal) {
    constexpr float kCell = 8;  // 512ths of the height: less than outlines are apart, more than noise is fine.
    const glm::dvec4 in_eye = view.eye_from_world() * glm::dvec4(center, 1);
    return relief_of(view, depths, kCell * settings.unit, -in_eye.z, diagonal);
}

}  // namespace npr
