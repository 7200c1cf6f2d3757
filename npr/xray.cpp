#include "npr/xray.h"

#include <array>

#include "npr/edge_map.h"
#include "npr/edge_parameters.h"
#include "npr/style_pass.h"

namespace npr {
namespace {

enum : int { kWidth, kCrease, kParts, kOpacity, kRim, kEdges, kInner, kFalloff, kCue, kColors, kLayers };

std::span<const Parameter> parameters() {
    static const std::array list{
        line_width(1.25F),
        crease_angle(),
        part_edges(),
        Parameter::number("opacity", "Opacity of a layer", 0.16F, 0, 1),
        Parameter::number("rim", "Opacity at outlines", 0.8F, 0, 2),
        Parameter::number("edges", "Strength of profile edges", 0.9F, 0, 1),
        Parameter::number("inner", "Strength of inner edges", 0.7F, 0, 1),
        Parameter::number("falloff", "Fading of edges from layer to layer", 0.93F, 0, 1),
        Parameter::number("cue", "Fading of what is far", 0.45F, 0, 1),
        Parameter::choice("colors", "Colors of", 0, {"model", "layers", "none"}),
        Parameter::integer("layers", "Layers (0: all)", 0, 0, 64),
    };
    return list;
}

class Xray : public Style {
  public:
    explicit Xray(const gl::Functions& gl) : edges_(gl), pass_(gl, "npr/xray.frag") {}

    /// Surfaces are looked for in all layers of the neighbours, whichever layers are drawn.
    [[nodiscard]] int layers_needed(const Parameters& /*parameters*/, bool /*translucent*/) const override { return 0; }

    void draw(const Frame& frame) override {
        const Parameters& p = frame.parameters;
        edges_.draw(frame, {p.number(kCrease), p.toggle(kParts)});
        const gl::Program& program = pass_.program();
        program.set("width", p.number(kWidth));
        program.set("opacity", p.number(kOpacity));
        program.set("rim", p.number(kRim));
        program.set("profile_strength", p.number(kEdges));
        program.set("inner_strength", p.number(kInner));
        program.set("falloff", p.number(kFalloff));
        program.set("cue", p.number(kCue));
        program.set("colors", p.choice(kColors));
        program.set("most_layers", p.integer(kLayers));
        pass_.draw(frame);
    }

  private:
    EdgeMap edges_;
    StylePass pass_;
};

}  // namespace

StyleInfo xray_style() {
    return {"xray", "X-ray", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Xray>(gl); }};
}

}  // namespace npr
