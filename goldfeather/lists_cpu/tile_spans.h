// The rows of one tile as spans: which triangle covers which pixels.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "goldfeather/lists_cpu/screen_triangles.h"

namespace goldfeather {

/// Pixels x0 ≤ x < x1, y0 ≤ y < y1; at most TileSpans::kSide on a side.
struct TileBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Spans are kept by row and first pixel. Where none begins and none has ended, neighboring pixels are covered by the
/// same triangles: a run.
class TileSpans {
  public:
    static constexpr int kSide = 32;
    static constexpr int kPixels = kSide * kSide;

    explicit TileSpans(std::span<const ScreenTriangle> triangles) : triangles_(triangles) {}

    /// Empties the tile. `most`: spans it may hold.
    void start(const TileBox& box, std::size_t most);
    /// Adds the pixels whose center the triangle covers. Gives false where the tile would hold more than `most` spans.
    [[nodiscard]] bool add(std::uint32_t triangle);

    /// Rows and pixels count from the box's corner. Bit x: a span begins in pixel x, or one has ended before it.
    [[nodiscard]] std::uint32_t bounds(int row) const { return bounds_[static_cast<std::size_t>(row)]; }
    /// Calls action(triangle, last pixel) for the spans that begin in the pixel, in an order that is always the same.
    template <typename Action>
    void for_each_from(int row, int pixel, const Action& action) const {
        for (std::uint32_t i = heads_[head(row, pixel)]; i != kNone; i = spans_[i].next) {
            action(spans_[i].triangle, static_cast<int>(spans_[i].last));
        }
    }
    static int pixel_of(int x, int y) { return y * kSide + x; }  ///< From the tile's corner.

  private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    struct Span {
        std::uint32_t triangle, next, last;
    };
    static std::size_t head(int row, int pixel) { return static_cast<std::size_t>(row * kSide + pixel); }

    std::span<const ScreenTriangle> triangles_;
    TileBox box_;
    std::size_t most_ = 0;
    std::vector<Span> spans_;
    std::array<std::uint32_t, kPixels> heads_{};
    std::array<std::uint32_t, kSide> bounds_{};
};

}  // namespace goldfeather
