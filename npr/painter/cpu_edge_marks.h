// Where in the picture there may be lines, coarsely.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "layers/limits.h"

namespace npr {

/// For blocks of pixels, which kinds of lines may cover them: what the tiles of npr/edges/edge_point.glsl are to
/// shaders.
class EdgeMarks {
  public:
    /// A bit for each layer that is kept apart, and one for lines beyond their ends.
    static constexpr std::uint32_t kBeyond = 1U << layers::kLayersApart;

    /// Forgets all marks.
    void resize(glm::ivec2 picture);
    /// Of lines about an edge on a link that starts at the pixel. Any number of threads may mark at once.
    void mark(glm::ivec2 lower, std::uint32_t bits);
    /// To be called when all is marked. `width`: pixels, of the widest line.
    void spread(float width);
    /// What may be near a place anywhere in the picture's plane, counted in samples.
    [[nodiscard]] std::uint32_t near(glm::vec2 at) const {
        const glm::ivec2 block = glm::clamp(glm::ivec2(at), glm::ivec2(0), last_pixel_) / kSide;
        return marks_[index(block)];
    }

  private:
    static constexpr int kSide = 4;  ///< Of a block, in pixels.
    [[nodiscard]] std::size_t index(glm::ivec2 block) const {
        return static_cast<std::size_t>(block.y) * static_cast<std::size_t>(blocks_.x) +
               static_cast<std::size_t>(block.x);
    }
    /// Each block takes over what those up to `reach` before and behind it along an axis hold.
    void spread_along(int axis, int reach);

    glm::ivec2 last_pixel_{0}, blocks_{0};
    std::vector<std::uint32_t> marks_, before_;
};

}  // namespace npr
