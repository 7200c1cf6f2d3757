#include "goldfeather/tile_lists.h"

#include <algorithm>
#include <cmath>

namespace goldfeather {

namespace {

constexpr std::int64_t kHalf = kSubpixels / 2;

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    const std::int64_t q = a / b;
    return q * b > a ? q - 1 : q;
}

/// An edge from p to q with the triangle on its left. A sample on it belongs to the triangle where the edge goes up, or
/// is level and goes right: of two triangles that meet in the edge, to just one.
struct Edge {
    std::int64_t px, py, dx, dy;

    /// Narrows [first, last], the pixels of the row whose samples are at `sy`.
    void narrow(std::int64_t sy, std::int64_t& first, std::int64_t& last) const {
        // Inside: dx (sy - py) - dy (sx - px) > 0 with sx = x * kSubpixels + kHalf.
        const std::int64_t rest = dx * (sy - py) + dy * (px - kHalf);
        if (dy > 0) {
            last = std::min(last, floor_divide(rest, dy * kSubpixels));
        } else if (dy < 0) {
            first = std::max(first, floor_divide(-rest, -dy * kSubpixels) + 1);
        } else if (dx * (sy - py) < 0 || (sy == py && dx < 0)) {
            last = first - 1;
        }
    }
};

}  // namespace

void TileLists::start(const TileBox& box, std::uint32_t most) {
    box_ = box;
    most_ = most;
    counts_.fill(0);
}

void TileLists::grow() {
    capacity_ = std::max(8U, 2 * capacity_);
    depths_.resize(std::size_t{capacity_} * kPixels);
    triangles_.resize(std::size_t{capacity_} * kPixels);
}

bool TileLists::add(const ScreenTriangle& t, std::uint32_t index) {
    const auto [low, high] = std::minmax({t.y[0], t.y[1], t.y[2]});
    const std::int64_t first_row = std::max<std::int64_t>(box_.y0, (low + kHalf - 1) >> kSubpixelBits);
    const std::int64_t last_row = std::min<std::int64_t>(box_.y1 - 1, (high - kHalf) >> kSubpixelBits);
    if (first_row > last_row) {
        return true;
    }
    std::array<Edge, 3> edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        edges[i] = {t.x[i], t.y[i], std::int64_t{t.x[j]} - t.x[i], std::int64_t{t.y[j]} - t.y[i]};
    }
    const gl::View::ExactPlaneDepth& plane = planes_[t.plane];
    // Snapping has moved the border by up to 2⁻¹⁴ pixel: a sample there must not be thrown far along a steep plane.
    const double slack = std::min(0x1p-13 * (std::abs(plane.a) + std::abs(plane.b)), 0.25 * (t.nearest - t.farthest)) +
                         1e-12 * t.nearest;
    const double least = t.farthest - slack, most_near = t.nearest + slack;
    for (std::int64_t y = first_row; y <= last_row; ++y) {
        std::int64_t first = box_.x0, last = box_.x1 - 1;
        const std::int64_t sy = y * kSubpixels + kHalf;
        for (const Edge& edge : edges) {
            edge.narrow(sy, first, last);
        }
        if (first > last) {
            continue;
        }
        const double along_y = plane.b * (static_cast<double>(y) + 0.5 - half_.y);
        std::size_t pixel = static_cast<std::size_t>((y - box_.y0) * kSide + first - box_.x0);
        for (std::int64_t x = first; x <= last; ++x, ++pixel) {
            const std::uint32_t k = counts_[pixel];
            if (k == capacity_) {
                grow();
            }
            if (k == most_) {
                return false;
            }
            counts_[pixel] = k + 1;
            const double depth = plane.edge_on
                                     ? 0.5 * (t.farthest + t.nearest)
                                     : (plane.a * (static_cast<double>(x) + 0.5 - half_.x) + along_y) + plane.c;
            depths_[std::size_t{k} * kPixels + pixel] = std::clamp(depth, least, most_near);
            triangles_[std::size_t{k} * kPixels + pixel] = index;
        }
    }
    return true;
}

}  // namespace goldfeather
