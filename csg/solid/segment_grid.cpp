#include "csg/solid/segment_grid.h"

#include <cmath>

namespace csg::solid {
namespace {

constexpr double kCellMargin = 1e-5;   // Of a cell; beyond the rounding of what is computed here.
constexpr double kSteep = 1e-3;        // Cells; across less than that all rows of an edge are taken.
constexpr double kMostEntries = 24e6;  // Cells become larger rather than that there are more.

}  // namespace

template <typename F>
void SegmentGrid::along(const GridEdge& edge, F&& f) const {
    const double ax = (static_cast<double>(edge.a.x) - x_) * per_x_, bx = (static_cast<double>(edge.b.x) - x_) * per_x_;
    const double ay = (static_cast<double>(edge.a.y) - y_) * per_y_, by = (static_cast<double>(edge.b.y) - y_) * per_y_;
    const std::size_t first = column(ax - kCellMargin), last = column(bx + kCellMargin);
    for (std::size_t c = first; c <= last; ++c) {
        double low = ay, high = by;
        if (bx - ax > kSteep) {
            const double left = std::max(ax, static_cast<double>(c) - kCellMargin);
            const double right = std::min(bx, static_cast<double>(c + 1) + kCellMargin);
            low = ay + (by - ay) * (left - ax) / (bx - ax);
            high = ay + (by - ay) * (right - ax) / (bx - ax);
        }
        if (low > high) {
            std::swap(low, high);
        }
        for (std::size_t row = column(low - kCellMargin); row <= column(high + kCellMargin); ++row) {
            f(row * side_ + c);
        }
    }
}

SegmentGrid::SegmentGrid(std::span<const GridEdge> edges) {
    if (!edges.empty()) {
        GridPoint lo = edges[0].a, hi = lo;
        for (const GridEdge& e : edges) {
            lo = {std::min(lo.x, e.a.x), std::min({lo.y, e.a.y, e.b.y})};
            hi = {std::max(hi.x, e.b.x), std::max({hi.y, e.a.y, e.b.y})};
        }
        x_ = static_cast<double>(lo.x);
        y_ = static_cast<double>(lo.y);
        const double width = static_cast<double>(hi.x - lo.x) + 1, height = static_cast<double>(hi.y - lo.y) + 1;
        double length = 0;
        for (const GridEdge& e : edges) {
            length +=
                static_cast<double>(e.b.x - e.a.x) / width + static_cast<double>(std::abs(e.b.y - e.a.y)) / height;
        }
        double side = std::min(std::sqrt(static_cast<double>(edges.size())), 1024.0);
        if (length > 0) {
            side = std::min(side, kMostEntries / length);
        }
        // Cells are wider than the unit squares that are looked up.
        side = std::max(1.0, std::floor(std::min({side, width / 4, height / 4})));
        side_ = static_cast<std::size_t>(side);
        per_x_ = side / width;
        per_y_ = side / height;
    }
    begin_.assign(side_ * side_ + 1, 0);
    for (const GridEdge& e : edges) {
        along(e, [&](std::size_t cell) { ++begin_[cell + 1]; });
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) {
        begin_[i] += begin_[i - 1];
    }
    entries_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        along(edges[i], [&](std::size_t cell) { entries_[next[cell]++] = i; });
    }
}

}  // namespace csg::solid
