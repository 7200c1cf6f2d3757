// The tiles of layers in main memory.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

#include "layers/host_stack.h"

namespace npr {

/// Pixels; lo inclusive, hi exclusive.
struct TileBounds {
    glm::ivec2 lo{0}, hi{0};
};

class Tiles {
  public:
    static constexpr int kSide = layers::HostStack::kTileSide;

    /// `layers` must outlive the object.
    explicit Tiles(const layers::HostStack& layers) : layers_(layers), across_((layers.size + kSide - 1) / kSide) {}

    [[nodiscard]] int count() const { return across_.x * across_.y; }
    [[nodiscard]] TileBounds bounds(int tile) const {
        const glm::ivec2 lo = kSide * glm::ivec2(tile % across_.x, tile / across_.x);
        return {lo, glm::min(lo + kSide, layers_.size)};
    }
    /// The tile of a pixel, which must be in the picture.
    [[nodiscard]] int tile_of(glm::ivec2 pixel) const {
        const glm::ivec2 at = pixel / kSide;
        return at.y * across_.x + at.x;
    }
    /// Calls action(tile) for the tile and those about it.
    template <typename Action>
    void for_each_about(int tile, const Action& action) const {
        const glm::ivec2 at(tile % across_.x, tile / across_.x);
        const glm::ivec2 lo = glm::max(at - 1, 0), hi = glm::min(at + 1, across_ - 1);
        for (int y = lo.y; y <= hi.y; ++y) {
            for (int x = lo.x; x <= hi.x; ++x) {
                action(y * across_.x + x);
            }
        }
    }
    /// The most layers in which the tile, or one about it, holds a surface.
    [[nodiscard]] int held_about(int tile) const {
        int most = 0;
        for_each_about(tile, [&](int other) { most = std::max(most, layers_.held[static_cast<std::size_t>(other)]); });
        return std::min(most, layers_.layers);
    }

  private:
    const layers::HostStack& layers_;
    glm::ivec2 across_;  ///< In tiles.
};

}  // namespace npr
