#include "npr/styles/blueprint.h"

#include <array>

#include "npr/edges/edge_parameters.h"
#include "npr/painter/cpu_paint.h"
#include "npr/styles/lined_style.h"

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

/// Under the names of the shader's uniforms.
struct Settings {
    float width{};
    float hidden_width{};
    float inner_strength{};
    float hidden_strength{};
    float hidden_falloff{};
    float tone{};
    int most_layers{};
    bool grid{};
    float grid_spacing{};
    glm::vec3 ground_color{};
    glm::vec3 line_color{};
    glm::vec3 wash_color{};
};

Settings settings_of(const Parameters& p) {
    Settings s;
    const glm::vec3 blue = glm::vec3(0x1b, 0x3f, 0x8b) / 255.0F, white = glm::vec3(0xf6, 0xf8, 0xfc) / 255.0F;
    const bool on_blue = p.choice(kGround) == 0;
    s.width = p.number(kWidth);
    s.hidden_width = 0.8F * p.number(kWidth);
    s.inner_strength = p.number(kInner);
    s.hidden_strength = p.number(kHidden);
    s.hidden_falloff = p.number(kFalloff);
    s.tone = p.number(kTone);
    s.most_layers = p.integer(kLayers);
    s.grid = p.toggle(kGrid);
    s.grid_spacing = static_cast<float>(p.integer(kSpacing));
    s.ground_color = on_blue ? blue : white;
    s.line_color = on_blue ? white : blue;
    s.wash_color = glm::vec3(0x5b, 0x97, 0xf2) / 255.0F;
    return s;
}

EdgeSettings edge_settings(const Parameters& p) {
    return {p.number(kCrease), p.toggle(kParts)};
}

void set_uniforms(const Parameters& parameters, const gl::Program& program) {
    const Settings s = settings_of(parameters);
    program.set("width", s.width);
    program.set("hidden_width", s.hidden_width);
    program.set("inner_strength", s.inner_strength);
    program.set("hidden_strength", s.hidden_strength);
    program.set("hidden_falloff", s.hidden_falloff);
    program.set("tone", s.tone);
    program.set("most_layers", s.most_layers);
    program.set("grid", s.grid);
    program.set("grid_spacing", s.grid_spacing);
    program.set("ground_color", s.ground_color);
    program.set("line_color", s.line_color);
    program.set("wash_color", s.wash_color);
}

using namespace glm;  // As shader files do.

struct BlueprintPixels : LinedFrame, Settings {
    BlueprintPixels(const CpuFrame& frame, const CpuEdges& edges, const Settings& s)
        : LinedFrame(frame, edges, {s.width, s.hidden_width, 1, s.inner_strength}), Settings(s) {}
#include "npr/styles/blueprint.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return blueprint(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return !grid && LinedFrame::as_left(p);
    }
};

void paint(const CpuFrame& frame) {
    const CpuEdges edges = find_edges(frame, edge_settings(frame.parameters));
    paint_tiles(frame, [&] { return BlueprintPixels(frame, edges, settings_of(frame.parameters)); });
}

}  // namespace

StyleInfo blueprint_style() {
    return {"blueprint", "Blueprint", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> {
                return std::make_unique<LinedStyle>(gl, "npr/styles/blueprint.frag", edge_settings, set_uniforms);
            },
            [] { return Paint(paint); }};
}

}  // namespace npr
