#include "npr/edges.h"

#include <array>

#include "npr/edge_map.h"
#include "npr/edge_parameters.h"
#include "npr/style_pass.h"

namespace npr {
namespace {

enum : int { kWidth, kCrease, kParts, kInner, kColor, kShade };

std::span<const Parameter> parameters() {
    static const std::array list{
        line_width(1.25F),
        crease_angle(),
        part_edges(),
        Parameter::number("inner", "Strength of inner edges", 0.85F, 0, 1),
        Parameter::color("edge-color", "Color of edges", {0.12F, 0.11F, 0.10F}),
        Parameter::number("shade", "Strength of surface colors", 1, 0, 1),
    };
    return list;
}

class Edges : public Style {
  public:
    explicit Edges(const gl::Functions& gl) : edges_(gl), pass_(gl, "npr/edges.frag") {}

    /// A surface is looked for in all layers of the neighbours.
    [[nodiscard]] int layers_needed(const Parameters& /*parameters*/, bool /*translucent*/) const override { return 0; }

    void draw(const Frame& frame) override {
        const Parameters& p = frame.parameters;
        const gl::Program& program = pass_.program();
        edges_.draw(frame, {p.number(kCrease), p.toggle(kParts), true});
        program.set("width", p.number(kWidth));
        program.set("inner_strength", p.number(kInner));
        program.set("edge_color", p.color(kColor));
        program.set("shade", p.number(kShade));
        pass_.draw(frame);
    }

  private:
    EdgeMap edges_;
    StylePass pass_;
};

}  // namespace

StyleInfo edges_style() {
    return {"edges", "Edges", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Edges>(gl); }};
}

}  // namespace npr
