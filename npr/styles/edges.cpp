#include "npr/styles/edges.h"

#include <array>

#include "npr/edges/edge_parameters.h"
#include "npr/painter/cpu_paint.h"
#include "npr/styles/lined_style.h"

namespace npr {
namespace {

enum : int { kWidth, kCrease, kParts, kInner, kColor, kShade, kLight, kSmooth };

std::span<const Parameter> parameters() {
    static const std::array list{
        line_width(1.25F),
        crease_angle(),
        part_edges(),
        Parameter::number("inner", "Strength of inner edges", 0.85F, 0, 1),
        Parameter::color("edge-color", "Color of edges", {0.12F, 0.11F, 0.10F}),
        Parameter::number("shade", "Strength of surface colors", 1, 0, 1),
        Parameter::number("light", "Strength of light on surfaces", 1, 0, 1),
        Parameter::toggle("smooth", "Smooth lines", true),
    };
    return list;
}

/// Under the names of the shader's uniforms.
struct Settings {
    float width{};
    float inner_strength{};
    glm::vec3 edge_color{};
    float shade{};
    float light_strength{};
    bool smooth_lines{};
};

Settings settings_of(const Parameters& p) {
    Settings s;
    s.width = p.number(kWidth);
    s.inner_strength = p.number(kInner);
    s.edge_color = p.color(kColor);
    s.shade = p.number(kShade);
    s.light_strength = p.number(kLight);
    s.smooth_lines = p.toggle(kSmooth);
    return s;
}

EdgeSettings edge_settings(const Parameters& p) {
    return {p.number(kCrease), p.toggle(kParts), true};
}

void set_uniforms(const Parameters& parameters, const gl::Program& program) {
    const Settings s = settings_of(parameters);
    program.set("width", s.width);
    program.set("inner_strength", s.inner_strength);
    program.set("edge_color", s.edge_color);
    program.set("shade", s.shade);
    program.set("light_strength", s.light_strength);
    program.set("smooth_lines", s.smooth_lines);
}

using namespace glm;  // As shader files do.

struct EdgesPixels : LinedFrame, Settings {
    EdgesPixels(const CpuFrame& frame, const CpuEdges& edges, const Settings& s)
        : LinedFrame(frame, edges, {s.width, s.width, 1, s.inner_strength, !s.smooth_lines}), Settings(s) {}
#include "npr/styles/edges.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return edges(p);
    }
};

void paint(const CpuFrame& frame) {
    const CpuEdges edges = find_edges(frame, edge_settings(frame.parameters));
    paint_tiles(frame, [&] { return EdgesPixels(frame, edges, settings_of(frame.parameters)); });
}

}  // namespace

StyleInfo edges_style() {
    return {"edges", "Edges", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> {
                return std::make_unique<LinedStyle>(gl, "npr/styles/edges.frag", edge_settings, set_uniforms);
            },
            [] { return Paint(paint); }};
}

}  // namespace npr
