// Drawn by hand (Nienhaus 2005, chapter 6).
#include <optional>

#include "npr/edges/edge_map.h"
#include "npr/edges/overshoot.h"
#include "npr/guard_band.h"
#include "npr/style_pass.h"
#include "npr/styles/cpu_sketch.h"
#include "npr/styles/sketch.h"
#include "npr/styles/sketch_settings.h"

namespace npr {
namespace {

/// As CpuSketchNoise.
class Noise {
  public:
    Noise(const gl::Functions& gl, const Hand& hand)
        : gl_(gl), pass_(gl, "npr/styles/sketch_noise.frag", {hand.table->declarations()}), target_(gl), relief_(gl) {}

    void draw(const Frame& frame, const SketchSettings& settings) {
        const NoiseKey key = noise_key(settings, frame.layers.size, frame.picture.guard);
        if (!(texture_ && texture_.size() == key.size)) {
            texture_ = gl::Texture::make_2d(gl_, GL_RGBA32F, key.size);
        }
        if (!(key_ && *key_ == key && (frame.sample > 0 || !settings.on_model))) {
            target_.attach({&texture_});
            lay_out(frame, settings);
            SketchSettings::table().set_uniforms(pass_.program(), settings);
            pass_.draw(frame, target_);
            key_ = key;
        }
        texture_.bind(7);
    }

  private:
    void lay_out(const Frame& frame, const SketchSettings& settings) {
        const auto& tables = *frame.layers.table;
        const Relief relief = settings.on_model ? sketch_relief(frame.view, layers::first_depths(gl_, frame.layers),
                                                                settings, tables.local_center, tables.diagonal)
                                                : Relief();
        relief_.upload<float>(relief.distances, GL_DYNAMIC_DRAW);
        relief_.bind(GL_SHADER_STORAGE_BUFFER, 15);
        pass_.program().set("relief_cell", relief.cell);
        pass_.program().set("relief_cells", relief.size);
    }

    const gl::Functions& gl_;
    StylePass pass_;
    gl::Framebuffer target_;
    gl::Buffer relief_;    ///< Relief::distances.
    gl::Texture texture_;  ///< RGBA32F.
    std::optional<NoiseKey> key_;
};

class Sketch : public Style {
  public:
    Sketch(const gl::Functions& gl, const Hand& hand)
        : hand_(hand),
          edges_(gl),
          overshoot_(gl),
          noise_(gl, hand),
          pass_(gl, "npr/styles/sketch.frag", {hand.table->declarations(), {}, {{"OVERSHOOT", "1"}}}) {}

    void draw(const Frame& frame) override {
        const SketchSettings settings = hand_.settings(frame.picture);
        noise_.draw(frame, settings);
        edges_.draw(frame, settings);
        overshoot_.draw(frame, edges_, settings.overshoot_length);
        pass_.set(settings);
        pass_.draw(frame);
    }

  private:
    Hand hand_;
    EdgeMap edges_;
    Overshoot overshoot_;
    Noise noise_;
    StylePass pass_;
};

}  // namespace

StyleInfo drawn_by_hand(std::string_view name, std::string_view label, const SettingsTable<SketchSettings>& table,
                        void (*set)(SketchSettings&)) {
    const Hand hand{&table, set};
    return {name,
            label,
            table.parameters(),
            [hand](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Sketch>(gl, hand); },
            [hand] { return make_sketch_paint(hand); },
            all_layers,
            [hand](const Picture& picture) {
                const SketchSettings settings = hand.settings(picture);
                // Noise sets strokes off by twice the deviation at most.
                return reach_of_lines(widest_stroke(settings)) + static_cast<int>(2 * settings.wobble);
            }};
}

StyleInfo sketch_style() {
    return drawn_by_hand("sketch", "Sketch", SketchSettings::table(), [](SketchSettings&) {});
}

}  // namespace npr
