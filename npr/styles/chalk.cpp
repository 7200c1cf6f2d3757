// Chalk on a board: every pixel has an offset of its own (Nienhaus 2005, 6.6).
#include "npr/smooth_shading.h"
#include "npr/styles/sketch.h"

namespace npr {
namespace {

const SettingsTable<SketchSettings>& parameters() {
    using S = SketchSettings;
    static const SettingsTable<S> all{
        setting<&S::width>(line_width(1.6F)),
        setting<&S::crease_degrees>(crease_angle()),
        setting<&S::parts>(part_edges()),
        setting<&S::seed>(Parameter::integer("seed", "Seed", 1, 0, 9999)),
        setting<&S::wobble>(Parameter::number("wobble", "Deviation of strokes", 2, 0, 20)),
        setting<&S::strokes>(Parameter::integer("strokes", "Strokes per edge", 2, 1, 4)),
        setting<&S::overshoot_length>(Parameter::number("overshoot", "Length drawn beyond corners", 8, 0, 60)),
        setting<&S::medium>(),
        setting<&S::hatch>(Parameter::number("hatch", "Strength of hatching", 0.8F, 0, 1)),
        setting<&S::wash>(Parameter::number("color", "Strength of surface colors", 0.25F, 0, 1)),
        setting<&S::hidden>(),
        setting<&S::hidden_falloff>(),
        setting<&S::layer_tone>(),
        setting<&S::on_model>(Parameter::choice("anchor", "Noise anchored to", 1, {"picture", "model"})),
        setting<&S::ink_color>(Parameter::color("ink", "Color of strokes", {0.957F, 0.945F, 0.894F})),
        setting<&S::paper_color>(Parameter::color("paper", "Color of the paper", {0.141F, 0.204F, 0.184F})),
        setting<&S::smooth_shading>(smooth_surfaces()),
        setting<&S::unit>(),
        setting<&S::hidden_width>(),
        setting<&S::inner_strength>(),
        setting<&S::hidden_inner>(),
        setting<&S::correlated>(),
    };
    return all;
}

}  // namespace

StyleInfo chalk_style() {
    return drawn_by_hand("chalk", "Chalk", parameters(), [](SketchSettings& s) { s.medium = 2; });
}

}  // namespace npr
