// Drawn by hand (Nienhaus 2005, chapter 6).
#include <optional>

#include "npr/edges/edge_map.h"
#include "npr/edges/overshoot.h"
#include "npr/style.h"
#include "npr/style_pass.h"
#include "npr/styles/cpu_sketch.h"
#include "npr/styles/sketch_settings.h"

namespace npr {
namespace {

/// The noise of a picture, kept while it stays the same.
class Noise {
  public:
    explicit Noise(const gl::Functions& gl)
        : gl_(gl), pass_(gl, "npr/styles/sketch_noise.frag", {SketchSettings::table().declarations()}), target_(gl) {}

    void draw(const Frame& frame, const SketchSettings& settings) {
        const auto& tables = *frame.layers.table;
        const NoiseKey key =
            noise_key(settings, frame.layers.size, {frame.view.camera(), tables.local_center, tables.diagonal});
        if (!(texture_ && texture_.size() == key.size)) {
            texture_ = gl::Texture::make_2d(gl_, GL_RGBA32F, key.size);
        }
        if (!(key_ && *key_ == key)) {
            target_.attach({&texture_});
            pass_.set(settings);
            pass_.draw(frame, target_);
            key_ = key;
        }
        texture_.bind(7);
    }

  private:
    const gl::Functions& gl_;
    StylePass pass_;
    gl::Framebuffer target_;
    gl::Texture texture_;  ///< RGBA32F.
    std::optional<NoiseKey> key_;
};

class Sketch : public Style {
  public:
    explicit Sketch(const gl::Functions& gl)
        : edges_(gl),
          overshoot_(gl),
          noise_(gl),
          pass_(gl, "npr/styles/sketch.frag", {SketchSettings::table().declarations(), {}, {{"OVERSHOOT", "1"}}}) {}

    void draw(const Frame& frame) override {
        const auto settings = settings_of<SketchSettings>(frame.picture);
        noise_.draw(frame, settings);
        edges_.draw(frame, settings);
        overshoot_.draw(frame, edges_, settings.overshoot_length);
        pass_.set(settings);
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
    return {"sketch", "Sketch", SketchSettings::table().parameters(),
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Sketch>(gl); },
            make_sketch_paint};
}

}  // namespace npr
