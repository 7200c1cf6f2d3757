// Sketched blueprints (Nienhaus 2005, 6.8): the edges of all layers, set off by the same noise, so that edges which
// follow each other stay together.
#include "npr/styles/sketch.h"

namespace npr {
namespace {

const SettingsTable<SketchSettings>& parameters() {
    static const SettingsTable<SketchSettings> all = hand_table({
        .width = 1.5F,
        .wobble = 3,
        .strokes = 2,
        .overshoot = 12,
        .ink = {0.965F, 0.973F, 0.988F},
        .paper = {0.106F, 0.247F, 0.545F},
        .hidden = Parameter::number("hidden", "Strength of hidden edges", 0.7F, 0, 1),
        .hidden_falloff = Parameter::number("falloff", "Fading from layer to layer", 0.8F, 0.01F, 1),
        .layer_tone = Parameter::number("tone", "Tone of a layer", 0.06F, 0, 0.25F),
    });
    return all;
}

}  // namespace

StyleInfo sketch_blueprint_style() {
    return drawn_by_hand("sketch-blueprint", "Sketched blueprint", parameters(), [](SketchSettings&) {});
}

}  // namespace npr
