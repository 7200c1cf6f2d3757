// Which segments pass through which cells of a uniform grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/solid/grid_point.h"

namespace csg::solid {

class SegmentGrid {
  public:
    explicit SegmentGrid(std::span<const GridEdge> edges);

    [[nodiscard]] std::size_t cells() const { return begin_.size() - 1; }
    /// Edges by their indices; none that passes through the cell is missing, and a few may pass it by.
    [[nodiscard]] std::span<const std::uint32_t> in(std::size_t cell) const {
        return {entries_.data() + begin_[cell], begin_[cell + 1] - begin_[cell]};
    }
    /// Calls `f` with the cells, up to four, that the unit square around a point reaches into.
    template <typename F>
    void around(const GridPoint& p, F&& f) const {
        const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
        const std::size_t left = column((x - 1 - x_) * per_x_), right = column((x + 1 - x_) * per_x_);
        const std::size_t low = column((y - 1 - y_) * per_y_), high = column((y + 1 - y_) * per_y_);
        for (std::size_t row = low; row <= high; ++row) {
            for (std::size_t at = left; at <= right; ++at) {
                f(row * side_ + at);
            }
        }
    }

  private:
    [[nodiscard]] std::size_t column(double at) const {
        return std::min(static_cast<std::size_t>(std::max(at, 0.0)), side_ - 1);
    }
    template <typename F>
    void along(const GridEdge& edge, F&& f) const;

    double x_ = 0, y_ = 0, per_x_ = 0, per_y_ = 0;
    std::size_t side_ = 1;
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> entries_;
};

}  // namespace csg::solid
