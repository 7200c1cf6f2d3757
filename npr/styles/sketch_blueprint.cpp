// Sketched blueprints (Nienhaus 2005, 6.8): the edges of all layers, set off by the same noise, so that edges which
// follow each other stay together.
#include "npr/styles/sketch.h"

namespace npr {
namespace {

const SettingsTable<SketchSettings>& parameters() {
    using S = SketchSettings;
    static const SettingsTable<S> all{
        setting<&S::width>(line_width(1.5F)),
        setting<&S::crease_degrees>(crease_angle()),
        setting<&S::parts>(part_edges()),
        setting<&S::seed>(Parameter::integer("seed", "Seed", 1, 0, 9999)),
        setting<&S::wobble>(Parameter::number("wobble", "Deviation of strokes", 3, 0, 20)),
        setting<&S::strokes>(Parameter::integer("strokes", "Strokes per edge", 2, 1, 4)),
        setting<&S::overshoot_length>(Parameter::number("overshoot", "Length drawn beyond corners", 12, 0, 60)),
        setting<&S::medium>(),
        setting<&S::hatch>(),
        setting<&S::wash>(),
        setting<&S::hidden>(Parameter::number("hidden", "Strength of hidden edges", 0.7F, 0, 1)),
        setting<&S::hidden_falloff>(Parameter::number("falloff", "Fading from layer to layer", 0.8F, 0.01F, 1)),
        setting<&S::layer_tone>(Parameter::number("tone", "Tone of a layer", 0.06F, 0, 0.25F)),
        setting<&S::on_model>(Parameter::choice("anchor", "Noise anchored to", 1, {"picture", "model"})),
        setting<&S::ink_color>(Parameter::color("ink", "Color of strokes", {0.965F, 0.973F, 0.988F})),
        setting<&S::paper_color>(Parameter::color("paper", "Color of the paper", {0.106F, 0.247F, 0.545F})),
        setting<&S::smooth_shading>(),
        setting<&S::unit>(),
        setting<&S::hidden_width>(),
        setting<&S::inner_strength>(),
        setting<&S::hidden_inner>(),
        setting<&S::correlated>(),
    };
    return all;
}

}  // namespace

StyleInfo sketch_blueprint_style() {
    return drawn_by_hand("sketch-blueprint", "Sketched blueprint", parameters(), [](SketchSettings&) {});
}

}  // namespace npr
