#include "npr/styles/sketch_settings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npr {
namespace {

enum : int {
    kWidth,
    kCrease,
    kParts,
    kSeed,
    kWobble,
    kStrokes,
    kOvershoot,
    kMedium,
    kHatch,
    kColor,
    kHidden,
    kAnchor,
    kInk,
    kPaper
};

}  // namespace

std::span<const Parameter> sketch_parameters() {
    static const std::array list{
        line_width(1.4F),
        crease_angle(),
        part_edges(),
        Parameter::integer("seed", "Seed", 1, 0, 9999),
        Parameter::number("wobble", "Deviation of strokes", 3, 0, 20),
        Parameter::integer("strokes", "Strokes per edge", 2, 1, 4),
        Parameter::number("overshoot", "Length drawn beyond corners", 16, 0, 60),
        Parameter::choice("medium", "Medium", 0, {"pencil", "ink", "chalk"}),
        Parameter::number("hatch", "Strength of hatching", 0.75F, 0, 1),
        Parameter::number("color", "Strength of surface colors", 0.55F, 0, 1),
        Parameter::number("hidden", "Strength of hidden edges", 0, 0, 1),
        Parameter::choice("anchor", "Noise anchored to", 0, {"picture", "model"}),
        Parameter::color("ink", "Color of strokes", {0.16F, 0.15F, 0.17F}),
        Parameter::color("paper", "Color of the paper", {0.975F, 0.957F, 0.915F}),
    };
    return list;
}

SketchSettings sketch_settings(const Parameters& p, glm::ivec2 size) {
    SketchSettings s;
    s.unit = static_cast<float>(size.y) / 512.0F;
    s.seed = static_cast<glm::uint>(p.integer(kSeed));
    s.width = p.number(kWidth) * std::sqrt(std::max(s.unit, 1.0F));
    s.wobble = s.unit * p.number(kWobble);
    s.strokes = p.integer(kStrokes);
    s.overshoot = s.unit * p.number(kOvershoot);
    s.medium = p.choice(kMedium);
    s.hatch = p.number(kHatch);
    s.wash = p.number(kColor);
    s.hidden = p.number(kHidden);
    s.on_model = p.choice(kAnchor) == 1;
    s.correlated = s.medium != 2;
    s.ink_color = p.color(kInk);
    s.paper_color = p.color(kPaper);
    return s;
}

EdgeSettings sketch_edges(const Parameters& p) {
    return {p.number(kCrease), p.toggle(kParts), p.number(kHidden) == 0.0F};
}

NoiseKey noise_key(const SketchSettings& settings, glm::ivec2 size, const NoiseKey::Anchor& anchor) {
    return {size, settings.seed, settings.correlated,
            settings.on_model ? std::optional(anchor) : std::optional<NoiseKey::Anchor>()};
}

}  // namespace npr
