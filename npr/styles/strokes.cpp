// Edges drawn again and again (Nienhaus 2005, 6.6): several edge maps, each perturbed by a matrix of its own.
#include "npr/styles/sketch.h"

namespace npr {
namespace {

const SettingsTable<SketchSettings>& parameters() {
    using S = SketchSettings;
    static const SettingsTable<S> all{
        setting<&S::width>(line_width(1)),
        setting<&S::crease_degrees>(crease_angle()),
        setting<&S::parts>(part_edges()),
        setting<&S::seed>(Parameter::integer("seed", "Seed", 1, 0, 9999)),
        setting<&S::wobble>(Parameter::number("wobble", "Deviation of strokes", 7, 0, 20)),
        setting<&S::strokes>(Parameter::integer("strokes", "Strokes per edge", 4, 1, 4)),
        setting<&S::overshoot_length>(Parameter::number("overshoot", "Length drawn beyond corners", 24, 0, 60)),
        setting<&S::medium>(),
        setting<&S::hatch>(),
        setting<&S::wash>(),
        setting<&S::hidden>(),
        setting<&S::hidden_falloff>(),
        setting<&S::layer_tone>(),
        setting<&S::on_model>(Parameter::choice("anchor", "Noise anchored to", 1, {"picture", "model"})),
        setting<&S::ink_color>(Parameter::color("ink", "Color of strokes", {0.13F, 0.12F, 0.14F})),
        setting<&S::paper_color>(Parameter::color("paper", "Color of the paper", {1, 1, 1})),
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

StyleInfo strokes_style() {
    return drawn_by_hand("strokes", "Repeated strokes", parameters(), [](SketchSettings& s) { s.medium = 1; });
}

}  // namespace npr
