#include "goldfeather/lists_cpu/tile_spans.h"

#include <algorithm>

namespace goldfeather {

namespace {

constexpr std::int64_t kHalf = kSubpixels / 2;

/// An edge from p to q with the triangle on its left, as the pixels of a row see it, from row to row. A sample on it
/// belongs to the triangle where the edge goes up, or is level and goes right: of two triangles that meet in the edge,
/// to just one.
///
/// A sample is inside where dx (sy - py) - dy (sx - px) > 0, sx = x · kSubpixels + kHalf: with rest = dx (sy - py) +
/// dy (px - kHalf) that is x < rest / (dy · kSubpixels) for an edge that goes up. The floor of that is the floor of
/// ⌊rest / kSubpixels⌋ / dy, whose numerator has less than 46 bits and whose denominator has less than 30: the quotient
/// of doubles is at least 1/dy away from the next integer, so that its floor is exact.
struct Edge {
    double numerator, step, denominator;  ///< Of the row; from row to row; the denominator is 0 for a level edge.
    bool up;

    Edge(const glm::i64vec2& p, const glm::i64vec2& q, std::int64_t x0, std::int64_t row) {
        const std::int64_t dx = q.x - p.x, dy = q.y - p.y;
        const std::int64_t rest = dx * (row * kSubpixels + kHalf - p.y) + dy * (p.x - kHalf - x0 * kSubpixels);
        up = dy > 0;
        numerator = static_cast<double>((up ? rest : -rest) >> kSubpixelBits);
        step = static_cast<double>(up ? dx : -dx);
        denominator = static_cast<double>(up ? dy : -dy);
    }
    /// The last pixel whose sample is left of it or on it, at least -1 and at most `most`.
    [[nodiscard]] int pixel(int most) const {
        const double at = std::clamp(numerator / denominator, -1.0, static_cast<double>(most));
        return static_cast<int>(at + 1.0) - 1;
    }
};

}  // namespace

void TileSpans::start(const TileBox& box, std::size_t most) {
    box_ = box;
    most_ = most;
    spans_.clear();
    heads_.fill(kNone);
    bounds_.fill(0);
}

bool TileSpans::add(std::uint32_t triangle) {
    const ScreenTriangle& t = triangles_[triangle];
    const auto [low, high] = std::minmax({t.y[0], t.y[1], t.y[2]});
    const std::int64_t first_row = std::max<std::int64_t>(box_.y0, (low + kHalf - 1) >> kSubpixelBits);
    std::int64_t last_row = std::min<std::int64_t>(box_.y1 - 1, (high - kHalf) >> kSubpixelBits);
    if (first_row > last_row) {
        return true;
    }
    const auto edge = [&](std::size_t i) {
        const std::size_t j = (i + 1) % 3;
        return Edge({t.x[i], t.y[i]}, {t.x[j], t.y[j]}, box_.x0, first_row);
    };
    std::array<Edge, 3> edges{edge(0), edge(1), edge(2)};
    for (std::size_t i = 0; i < 3; ++i) {
        // The samples on a level edge at the top are not the triangle's.
        if (edges[i].denominator == 0 && t.y[i] == high && last_row * kSubpixels + kHalf == high) {
            --last_row;
        }
    }
    const int width = box_.x1 - box_.x0;
    for (std::int64_t y = first_row; y <= last_row; ++y) {
        int first = 0, last = width - 1;
        for (Edge& e : edges) {
            if (e.denominator != 0) {
                const int pixel = e.pixel(width);
                if (e.up) {
                    last = std::min(last, pixel);
                } else {
                    first = std::max(first, pixel + 1);
                }
                e.numerator += e.step;
            }
        }
        if (first > last) {
            continue;
        }
        if (spans_.size() >= most_) {
            return false;
        }
        const int row = static_cast<int>(y) - box_.y0;
        std::uint32_t& begin = heads_[head(row, first)];
        spans_.push_back({triangle, begin, static_cast<std::uint32_t>(last)});
        begin = static_cast<std::uint32_t>(spans_.size() - 1);
        // Shifted in 64 bits: the pixel behind the last one of a row has no bit.
        bounds_[static_cast<std::size_t>(row)] |=
            static_cast<std::uint32_t>(std::uint64_t{1} << first | std::uint64_t{2} << last);
    }
    return true;
}

}  // namespace goldfeather
