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
    double numerator, step, denominator;  ///< Of the first row; from row to row; the denominator is 0 for a level edge.
    bool up;

    Edge(const glm::i64vec2& p, const glm::i64vec2& q, std::int64_t x0, std::int64_t row) {
        const std::int64_t dx = q.x - p.x, dy = q.y - p.y;
        const std::int64_t rest = dx * (row * kSubpixels + kHalf - p.y) + dy * (p.x - kHalf - x0 * kSubpixels);
        up = dy > 0;
        numerator = static_cast<double>((up ? rest : -rest) >> kSubpixelBits);
        step = static_cast<double>(up ? dx : -dx);
        denominator = static_cast<double>(up ? dy : -dy);
    }
    /// Where it passes the samples of the i-th row, in pixels from the tile's corner: the floor is the last pixel whose
    /// sample is left of it or on it.
    [[nodiscard]] double at(int i) const { return (numerator + i * step) / denominator; }
};

/// Between which places the samples of each row are inside. Floors are taken last: they keep the order of numbers, and
/// without them the loops below become vector instructions.
class RowLimits {
  public:
    RowLimits(int rows, int width) : rows_(rows), width_(width) {
        std::fill_n(left_.begin(), rows, -1.0);
        std::fill_n(right_.begin(), rows, width - 1.0);
    }
    /// False where nothing is left of any row.
    [[nodiscard]] bool cut(const Edge& edge) {
        if (rows_ > kFew) {
            // Where it passes all rows beside the tile, nothing or all is cut off.
            const auto [least, most] = std::minmax({edge.at(0), edge.at(rows_ - 1)});
            if (most < 0 || least >= width_ - 1) {
                return edge.up ? most >= 0 : most < 0;
            }
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(rows_); ++i) {
            const double at = edge.at(static_cast<int>(i));
            if (edge.up) {
                right_[i] = at < right_[i] ? at : right_[i];
            } else {
                left_[i] = at > left_[i] ? at : left_[i];
            }
        }
        return true;
    }
    [[nodiscard]] int first(int i) const {
        return static_cast<int>(std::min(left_[static_cast<std::size_t>(i)], static_cast<double>(width_)) + 1.0);
    }
    [[nodiscard]] int last(int i) const {
        return static_cast<int>(std::max(right_[static_cast<std::size_t>(i)], -1.0) + 1.0) - 1;
    }

  private:
    static constexpr int kFew = 3;
    int rows_, width_;
    std::array<double, TileSpans::kSide> left_, right_;
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
    const std::array<Edge, 3> edges{edge(0), edge(1), edge(2)};
    for (std::size_t i = 0; i < 3; ++i) {
        // The samples on a level edge at the top are not the triangle's.
        if (edges[i].denominator == 0 && t.y[i] == high && last_row * kSubpixels + kHalf == high) {
            --last_row;
        }
    }
    const int rows = static_cast<int>(last_row - first_row) + 1;
    if (rows <= 0) {
        return true;
    }
    RowLimits limits(rows, box_.x1 - box_.x0);
    for (const Edge& e : edges) {
        if (e.denominator != 0 && !limits.cut(e)) {
            return true;
        }
    }
    const int lowest = static_cast<int>(first_row) - box_.y0;
    for (int i = 0; i < rows; ++i) {
        const int first = limits.first(i), last = limits.last(i);
        if (first > last) {
            continue;
        }
        if (spans_.size() >= most_) {
            return false;
        }
        const int row = lowest + i;
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
