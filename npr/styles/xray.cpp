#include "npr/styles/xray.h"

#include <array>

#include "npr/edges/edge_parameters.h"
#include "npr/painter/cpu_paint.h"
#include "npr/styles/lined_style.h"

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

/// Under the names of the shader's uniforms.
struct Settings {
    float width{};
    float opacity{};
    float rim{};
    float profile_strength{};
    float inner_strength{};
    float falloff{};
    float cue{};
    int colors{};
    int most_layers{};
};

Settings settings_of(const Parameters& p) {
    Settings s;
    s.width = p.number(kWidth);
    s.opacity = p.number(kOpacity);
    s.rim = p.number(kRim);
    s.profile_strength = p.number(kEdges);
    s.inner_strength = p.number(kInner);
    s.falloff = p.number(kFalloff);
    s.cue = p.number(kCue);
    s.colors = p.choice(kColors);
    s.most_layers = p.integer(kLayers);
    return s;
}

EdgeSettings edge_settings(const Parameters& p) {
    return {p.number(kCrease), p.toggle(kParts)};
}

void set_uniforms(const Parameters& parameters, const gl::Program& program) {
    const Settings s = settings_of(parameters);
    program.set("width", s.width);
    program.set("opacity", s.opacity);
    program.set("rim", s.rim);
    program.set("profile_strength", s.profile_strength);
    program.set("inner_strength", s.inner_strength);
    program.set("falloff", s.falloff);
    program.set("cue", s.cue);
    program.set("colors", s.colors);
    program.set("most_layers", s.most_layers);
}

using namespace glm;  // As shader files do.

struct XrayPixels : LinedFrame, Settings {
    XrayPixels(const CpuFrame& frame, const CpuEdges& edges, const Settings& s)
        : LinedFrame(frame, edges, {s.width, s.width, s.profile_strength, s.inner_strength}), Settings(s) {}
#include "npr/styles/xray.glsl"

    glm::vec4 pixel(glm::ivec2 p) {
        at = p;
        return xray(p);
    }
    /// Light and fog change from pixel to pixel wherever there is a surface.
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return surface_ids(p, 0).x == kNoSurface && LinedFrame::as_left(p);
    }
};

void paint(const CpuFrame& frame) {
    const CpuEdges edges = find_edges(frame, edge_settings(frame.parameters));
    paint_tiles(frame, [&] { return XrayPixels(frame, edges, settings_of(frame.parameters)); });
}

}  // namespace

StyleInfo xray_style() {
    return {"xray", "X-ray", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> {
                return std::make_unique<LinedStyle>(gl, "npr/styles/xray.frag", edge_settings, set_uniforms);
            },
            [] { return Paint(paint); }};
}

}  // namespace npr
