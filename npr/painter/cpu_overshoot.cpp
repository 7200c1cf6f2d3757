#include "npr/painter/cpu_overshoot.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "npr/shader_frame.h"

namespace npr {
namespace {

using namespace glm;  // As shader files do.

struct Continuations : shader::Frame {
    Continuations(const CpuFrame& frame, const EdgeIndex& edge_index, float length, CpuOvershoot& points)
        : Frame(frame), overshoot(length), index(edge_index), beyond(points) {}

    float overshoot;
    const EdgeIndex& index;
    CpuOvershoot& beyond;

    EdgePoint visible_edge(ivec2 lower, int axis) {
        for (const CpuEdge& e : index.at(lower)) {
            if (e.layer == 0 && e.axis == axis) {
                return edge_point(e.profile ? kProfileEdge : kInnerEdge, 1,
                                  e.at[axis] - static_cast<float>(lower[axis]), e.across);
            }
        }
        return edge_point(0, 0, 0, vec2(0));
    }
    void draw_beyond(ivec2 lower, int axis, EdgePoint e) { beyond.add(lower, axis, pack_edge(e)); }

#include "npr/edges/overshoot.glsl"
};

}  // namespace

void CpuOvershoot::draw(const CpuFrame& frame, const EdgeIndex& edges, const SketchSettings& settings) {
    size_ = frame.layers.size;
    points_.assign(2 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), 0);
    marks_.resize(size_);
    base::for_each_index(
        static_cast<int>(edges.edges().size()),
        [&] {
            return [&, rules = Continuations(frame, edges, settings.overshoot_length, *this)](int tile) mutable {
                for (const CpuEdge& e : edges.edges()[static_cast<std::size_t>(tile)]) {
                    marks_.mark(e.lower, 1U << e.layer);
                    if (e.layer == 0 && settings.overshoot_length > 0) {
                        rules.draw_on_link(e.lower, e.axis);
                    }
                }
            };
        },
        0, frame.stop);
    marks_.spread(widest_stroke(settings));
}

void CpuOvershoot::add(glm::ivec2 lower, int axis, std::uint32_t packed) {
    const std::atomic_ref<std::uint32_t> point(points_[index(lower, axis)]);
    std::uint32_t there = point.load(std::memory_order_relaxed);
    while (there < packed && !point.compare_exchange_weak(there, packed, std::memory_order_relaxed)) {
    }
    marks_.mark(lower, EdgeMarks::kBeyond);
}

}  // namespace npr
