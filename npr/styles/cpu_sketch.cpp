#include "npr/styles/cpu_sketch.h"

#include <memory>

#include "npr/painter/cpu_overshoot.h"
#include "npr/painter/cpu_paint.h"
#include "npr/styles/cpu_sketch_noise.h"

namespace npr {
namespace {

using namespace glm;  // As shader files do.

struct SketchPixels : shader::Frame, SketchSettings {
    SketchPixels(const CpuFrame& frame, const SketchSettings& settings, const EdgeIndex& edge_index,
                 const CpuOvershoot& continuations, const CpuSketchNoise& picture_noise)
        : Frame(frame), SketchSettings(settings), index(edge_index), beyond(continuations), noise(picture_noise) {}

    const EdgeIndex& index;
    const CpuOvershoot& beyond;
    const CpuSketchNoise& noise;

    [[nodiscard]] uint layers_near(vec2 at, float /*thick*/) const {
        return beyond.marks().near(at) & ((1U << kLayersApart) - 1);
    }

    Edge edge_at(vec2 at, int layer, float thick) {
        Edge edge = no_edge();
        const ivec4 links = links_near(at, thick);
        for (int y = links.y; y <= links.w; ++y) {
            for (int x = links.x; x <= links.z; ++x) {
                for (const CpuEdge& e : index.at({x, y})) {
                    if (e.layer == edge_layer(layer)) {
                        float& kind = e.profile ? edge.profile : edge.inner;
                        kind = max(kind, piece(at - e.at, e.across, thick));
                    }
                }
            }
        }
        return edge;
    }

    Edge overshoot_at(vec2 at, float thick) {
        Edge edge = no_edge();
        if ((beyond.marks().near(at) & EdgeMarks::kBeyond) == 0) {
            return edge;
        }
        const ivec4 links = links_near(at, thick);
        for (int y = links.y; y <= links.w; ++y) {
            for (int x = links.x; x <= links.z; ++x) {
                for (int axis = 0; axis < 2; ++axis) {
                    const uint bits = beyond.at({x, y}, axis);
                    if (bits != 0) {
                        const EdgePoint e = unpack_edge(bits);
                        const vec2 from_point = at - vec2(x, y) - e.at * vec2(1 - axis, axis);
                        float& kind = e.kind == kProfileEdge ? edge.profile : edge.inner;
                        kind = max(kind, e.thickness * piece(from_point, e.across, thick));
                    }
                }
            }
        }
        return edge;
    }

#include "npr/styles/noise.glsl"

#include "npr/styles/hatching.glsl"

#include "npr/styles/sketch.glsl"

    void begin(int /*tile*/) {}
    vec4 pixel(ivec2 p) {
        const std::size_t i = Frame::index(p);
        return sketch(p, noise.strokes(i), noise.grain(i));
    }
    /// Paper has a grain.
    [[nodiscard]] static bool as_left(ivec2 /*p*/) {
        return false;
    }
};

class SketchPainter {
  public:
    explicit SketchPainter(const Hand& hand) : hand_(hand) {}

    void paint(const CpuFrame& frame) {
        const SketchSettings settings = hand_.settings(frame.picture);
        noise_.draw(frame, settings);
        const CpuEdges edges = find_edges(frame, settings);
        const EdgeIndex index(frame.layers, edges);
        overshoot_.draw(frame, index, settings);
        paint_tiles(frame, [&] { return SketchPixels(frame, settings, index, overshoot_, noise_); });
    }

  private:
    Hand hand_;
    CpuSketchNoise noise_;
    CpuOvershoot overshoot_;
};

}  // namespace

Paint make_sketch_paint(const Hand& hand) {
    return [painter = std::make_shared<SketchPainter>(hand)](const CpuFrame& frame) { painter->paint(frame); };
}

}  // namespace npr
