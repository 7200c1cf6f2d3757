// Lists of fragments for the pixels of one tile.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "goldfeather/screen_triangles.h"

namespace goldfeather {

/// Depth on a plane in a picture: a x + b y + c, in double precision; see gl::View::plane_depth.
using PlaneDepths = std::span<const gl::View::ExactPlaneDepth>;

/// Pixels x0 ≤ x < x1, y0 ≤ y < y1; at most TileLists::kSide on a side.
struct TileBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

class TileLists {
  public:
    static constexpr int kSide = 32;
    static constexpr int kPixels = kSide * kSide;

    /// `half`: half the size of the picture, in pixels.
    TileLists(PlaneDepths planes, const glm::dvec2& half) : planes_(planes), half_(half) {}

    /// Empties the lists. `most`: fragments a pixel may have.
    void start(const TileBox& box, std::uint32_t most);
    /// Adds the triangle to the lists of the pixels whose centre it covers. Gives false where a list would pass `most`.
    [[nodiscard]] bool add(const ScreenTriangle& triangle, std::uint32_t index);

    [[nodiscard]] std::uint32_t count(int pixel) const { return counts_[static_cast<std::size_t>(pixel)]; }
    /// The k-th fragment of a pixel, in the order of adding.
    [[nodiscard]] double depth(int pixel, std::uint32_t k) const { return depths_[k * kPixels + std::size_t(pixel)]; }
    [[nodiscard]] std::uint32_t triangle(int pixel, std::uint32_t k) const {
        return triangles_[k * kPixels + std::size_t(pixel)];
    }
    static int pixel_of(int x, int y) { return y * kSide + x; }  ///< From the tile's corner.

  private:
    void grow();

    PlaneDepths planes_;
    glm::dvec2 half_;
    TileBox box_;
    std::uint32_t most_ = 0, capacity_ = 0;
    std::array<std::uint32_t, kPixels> counts_{};
    std::vector<double> depths_;            ///< By k, then pixel.
    std::vector<std::uint32_t> triangles_;  ///< Likewise.
};

}  // namespace goldfeather
