#include "npr/styles/cpu_sketch.h"

#include <array>
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

    /// Hidden lines of all layers are asked for at one place.
    Edge edge_at(vec2 at, int layer, float thick) {
        if (layer == 0) {
            Edge edge = no_edge();
            for_each_edge(at, thick, [&](const CpuEdge& e) {
                if (e.layer == 0) {
                    add_to(edge, e, at, thick);
                }
            });
            return edge;
        }
        if (at != gathered_at_ || thick != gathered_width_) {
            gathered_at_ = at;
            gathered_width_ = thick;
            gathered_.fill(no_edge());
            for_each_edge(at, thick, [&](const CpuEdge& e) { add_to(gathered_[e.layer], e, at, thick); });
        }
        return gathered_[static_cast<std::size_t>(edge_layer(layer))];
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

  private:
    template <typename Action>
    void for_each_edge(vec2 at, float thick, const Action& action) {
        const ivec4 links = links_near(at, thick);
        for (int y = links.y; y <= links.w; ++y) {
            for (int x = links.x; x <= links.z; ++x) {
                for (const CpuEdge& e : index.at({x, y})) {
                    action(e);
                }
            }
        }
    }
    void add_to(Edge& edge, const CpuEdge& e, vec2 at, float thick) {
        float& kind = e.profile ? edge.profile : edge.inner;
        kind = max(kind, piece(at - e.at, e.across, thick));
    }

    vec2 gathered_at_{-1e9F};
    float gathered_width_ = 0;
    std::array<Edge, layers::kLayersApart> gathered_{};  ///< There, by layer.
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
