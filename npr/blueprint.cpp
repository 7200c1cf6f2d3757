#include "npr/blueprint.h"

#include <array>

#include "npr/edge_map.h"
#include "npr/edge_parameters.h"
#include "npr/style_pass.h"

namespace npr {
namespace {

enum : int { kWidth, kCrease, kParts, kInner, kGround, kHidden, kFalloff, kTone, kLayers, kGrid, kSpacing };

std::span<const Parameter> parameters() {
    static const std::array list{
        line_width(1.25F),
        crease_angle(),
        part_edges(),
        Parameter::number("inner", "Strength of inner edges", 0.8F, 0, 1),
        Parameter::choice("ground", "Ground", 0, {"blue", "white"}),
        Parameter::number("hidden", "Strength of hidden edges", 0.45F, 0, 1),
        Parameter::number("falloff", "Fading from layer to layer", 0.75F, 0, 1),
        Parameter::number("tone", "Tone of a layer", 0.07F, 0, 0.25F),
        Parameter::integer("layers", "Layers (0: all)", 0, 0, 64),
        Parameter::toggle("grid", "Grid on the paper", false),
        Parameter::integer("grid-spacing", "Spacing of the grid", 16, 4, 128),
    };
    return list;
}

class Blueprint : public Style {
  public:
    explicit Blueprint(const gl::Functions& gl) : edges_(gl), pass_(gl, "npr/blueprint.frag") {}

    /// Surfaces are looked for in all layers of the neighbours, whichever layers are drawn.
    [[nodiscard]] int layers_needed(const Parameters& /*parameters*/, bool /*translucent*/) const override { return 0; }

    void draw(const Frame& frame) override {
        const Parameters& p = frame.parameters;
        const gl::Program& program = pass_.program();
        edges_.draw(frame, {p.number(kCrease), p.toggle(kParts)});
        program.set("width", p.number(kWidth));
        program.set("hidden_width", 0.8F * p.number(kWidth));
        program.set("inner_strength", p.number(kInner));
        program.set("hidden_strength", p.number(kHidden));
        program.set("hidden_falloff", p.number(kFalloff));
        program.set("tone", p.number(kTone));
        program.set("most_layers", p.integer(kLayers));
        program.set("grid", p.toggle(kGrid));
        program.set("grid_spacing", static_cast<float>(p.integer(kSpacing)));
        const glm::vec3 blue = glm::vec3(0x1b, 0x3f, 0x8b) / 255.0F, white = glm::vec3(0xf6, 0xf8, 0xfc) / 255.0F;
        const bool on_blue = p.choice(kGround) == 0;
        program.set("ground_color", on_blue ? blue : white);
        program.set("line_color", on_blue ? white : blue);
        program.set("wash_color", glm::vec3(0x5b, 0x97, 0xf2) / 255.0F);
        pass_.draw(frame);
    }

  private:
    EdgeMap edges_;
    StylePass pass_;
};

}  // namespace

StyleInfo blueprint_style() {
    return {"blueprint", "Blueprint", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Blueprint>(gl); }};
}

}  // namespace npr
