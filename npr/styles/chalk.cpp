// Chalk on a board: every pixel has an offset of its own (Nienhaus 2005, 6.6).
#include "npr/smooth_shading.h"
#include "npr/styles/sketch.h"

namespace npr {
namespace {

const SettingsTable<SketchSettings>& parameters() {
    static const SettingsTable<SketchSettings> all = hand_table({
        .width = 1.6F,
        .wobble = 2,
        .strokes = 2,
        .overshoot = 8,
        .ink = {0.957F, 0.945F, 0.894F},
        .paper = {0.141F, 0.204F, 0.184F},
        .hatch = Parameter::number("hatch", "Strength of hatching", 0.8F, 0, 1),
        .wash = Parameter::number("color", "Strength of surface colors", 0.25F, 0, 1),
        .smooth_shading = smooth_surfaces(),
    });
    return all;
}

}  // namespace

StyleInfo chalk_style() {
    return drawn_by_hand("chalk", "Chalk", parameters(), [](SketchSettings& s) { s.medium = 2; });
}

}  // namespace npr
