// Visible edges drawn on beyond their ends, without OpenGL (npr/edges/overshoot.h does it with).
#pragma once

#include <cstdint>
#include <vector>

#include "npr/painter/cpu_edge_index.h"
#include "npr/painter/cpu_edge_marks.h"
#include "npr/styles/sketch_settings.h"

namespace npr {

/// The continuations of a frame's straight visible edges; its memory is used again.
class CpuOvershoot {
  public:
    /// Marks the lines along all edges, too.
    void draw(const CpuFrame& frame, const EdgeIndex& edges, const SketchSettings& settings);

    /// Packed as in npr/edges/edge_point.glsl, on a pixel's link to the right (axis 0) or up; 0 where there is none.
    [[nodiscard]] std::uint32_t at(glm::ivec2 lower, int axis) const { return points_[index(lower, axis)]; }
    /// Where there may be lines along edges, or beyond them, of the settings' widths.
    [[nodiscard]] const EdgeMarks& marks() const { return marks_; }

    /// Where several continuations meet the strongest stays. Any number of threads may add at once.
    void add(glm::ivec2 lower, int axis, std::uint32_t packed);

  private:
    [[nodiscard]] std::size_t index(glm::ivec2 lower, int axis) const {
        return 2 * (static_cast<std::size_t>(lower.y) * static_cast<std::size_t>(size_.x) +
                    static_cast<std::size_t>(lower.x)) +
               static_cast<std::size_t>(axis);
    }

    glm::ivec2 size_{0};
    std::vector<std::uint32_t> points_;
    EdgeMarks marks_;
};

}  // namespace npr
