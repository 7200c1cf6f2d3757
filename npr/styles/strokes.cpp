// Edges drawn again and again (Nienhaus 2005, 6.6): several edge maps, each perturbed by a matrix of its own.
#include "npr/styles/sketch.h"

namespace npr {
namespace {

const SettingsTable<SketchSettings>& parameters() {
    static const SettingsTable<SketchSettings> all = hand_table({
        .width = 1,
        .wobble = 7,
        .strokes = 4,
        .overshoot = 24,
        .ink = {0.13F, 0.12F, 0.14F},
        .paper = {1, 1, 1},
    });
    return all;
}

}  // namespace

StyleInfo strokes_style() {
    return drawn_by_hand("strokes", "Repeated strokes", parameters(), [](SketchSettings& s) { s.medium = 1; });
}

}  // namespace npr
