#include "npr/sketch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "npr/edge_map.h"
#include "npr/edge_parameters.h"
#include "npr/overshoot.h"
#include "npr/style_pass.h"

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

std::span<const Parameter> parameters() {
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

/// The noise of a picture, kept while it stays the same: it does not depend on the sample's jitter.
class Noise {
  public:
    explicit Noise(const gl::Functions& gl) : gl_(gl), pass_(gl, "npr/sketch_noise.frag"), target_(gl) {}

    void draw(const Frame& frame, float unit) {
        const Parameters& p = frame.parameters;
        const bool on_model = p.choice(kAnchor) == 1;
        Key key{frame.layers.size, p.integer(kSeed), p.choice(kMedium), {}};
        if (on_model)
            key.camera = frame.view.camera();
        if (!(texture_ && texture_.size() == key.size))
            texture_ = gl::Texture::make_2d(gl_, GL_RGBA32F, key.size);
        if (!(key_ && *key_ == key)) {
            target_.attach({&texture_});
            const gl::Program& program = pass_.program();
            program.set("seed", static_cast<unsigned>(key.seed));
            program.set("unit", unit);
            program.set("on_model", on_model);
            program.set("correlated", key.medium != 2);
            pass_.draw(frame, target_);
            key_ = key;
        }
        texture_.bind(7);
    }

  private:
    struct Key {
        glm::ivec2 size;
        int seed, medium;
        std::optional<gl::Camera> camera;  ///< Where the noise is anchored to the model.
        bool operator==(const Key&) const = default;
    };
    const gl::Functions& gl_;
    StylePass pass_;
    gl::Framebuffer target_;
    gl::Texture texture_;  ///< RGBA32F.
    std::optional<Key> key_;
};

class Sketch : public Style {
  public:
    explicit Sketch(const gl::Functions& gl)
        : edges_(gl), overshoot_(gl), noise_(gl), pass_(gl, "npr/sketch.frag", {{"OVERSHOOT", "1"}}) {}

    void draw(const Frame& frame) override {
        const Parameters& p = frame.parameters;
        // Drawings of all sizes look the same, though with finer lines the larger they are.
        const float unit = static_cast<float>(frame.layers.size.y) / 512.0F;
        noise_.draw(frame, unit);
        edges_.draw(frame, {p.number(kCrease), p.toggle(kParts), p.number(kHidden) == 0.0F});
        overshoot_.draw(frame, edges_, unit * p.number(kOvershoot));
        const gl::Program& program = pass_.program();
        program.set("unit", unit);
        program.set("seed", static_cast<unsigned>(p.integer(kSeed)));
        program.set("width", p.number(kWidth) * std::sqrt(std::max(unit, 1.0F)));
        program.set("wobble", unit * p.number(kWobble));
        program.set("strokes", p.integer(kStrokes));
        program.set("medium", p.choice(kMedium));
        program.set("hatch", p.number(kHatch));
        program.set("wash", p.number(kColor));
        program.set("hidden", p.number(kHidden));
        program.set("ink_color", p.color(kInk));
        program.set("paper_color", p.color(kPaper));
        pass_.draw(frame);
    }

  private:
    EdgeMap edges_;
    Overshoot overshoot_;
    Noise noise_;
    StylePass pass_;
};

}  // namespace

StyleInfo sketch_style() {
    return {"sketch", "Sketch", parameters,
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Sketch>(gl); }};
}

}  // namespace npr
