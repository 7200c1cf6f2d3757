#include "npr/painter/cpu_edge_marks.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace npr {

void EdgeMarks::resize(glm::ivec2 picture) {
    last_pixel_ = picture - 1;
    blocks_ = (picture + kSide - 1) / kSide;
    marks_.assign(static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y), 0);
}

void EdgeMarks::mark(glm::ivec2 lower, std::uint32_t bits) {
    const std::atomic_ref<std::uint32_t> block(marks_[index(lower / kSide)]);
    if ((block.load(std::memory_order_relaxed) & bits) != bits) {
        block.fetch_or(bits, std::memory_order_relaxed);
    }
}

void EdgeMarks::spread(float width) {
    // From a place lines are looked for on links that start so far from it, and one pixel more to the left and below.
    const float reach = 0.5F * width + 0.5F;
    const int blocks = static_cast<int>(std::ceil((reach + 1) / static_cast<float>(kSide)));
    spread_along(0, blocks);
    spread_along(1, blocks);
}

void EdgeMarks::spread_along(int axis, int reach) {
    before_ = marks_;
    const glm::ivec2 step(1 - axis, axis);
    for (int y = 0; y < blocks_.y; ++y) {
        for (int x = 0; x < blocks_.x; ++x) {
            const glm::ivec2 at(x, y);
            const int first = std::max(-reach, -at[axis]), last = std::min(reach, blocks_[axis] - 1 - at[axis]);
            std::uint32_t bits = 0;
            for (int i = first; i <= last; ++i) {
                bits |= before_[index(at + i * step)];
            }
            marks_[index(at)] = bits;
        }
    }
}

}  // namespace npr
