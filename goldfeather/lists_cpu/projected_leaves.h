// The leaves of a scene on the screen: made for a view, and made good where a few of them have moved since.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/lists_cpu/screen_triangles.h"

namespace goldfeather {

/// Tiles of TileSpans::kSide pixels: from the first to before the last, in x and y.
struct TileRange {
    glm::ivec2 from{0}, to{0};
    [[nodiscard]] bool empty() const { return from.x >= to.x || from.y >= to.y; }
};
[[nodiscard]] TileRange tiles_of(const ScreenTriangle& triangle, glm::ivec2 tiles);
[[nodiscard]] inline bool overlap(const TileRange& a, const TileRange& b) {
    return std::max(a.from.x, b.from.x) < std::min(a.to.x, b.to.x) &&
           std::max(a.from.y, b.from.y) < std::min(a.to.y, b.to.y);
}

class ProjectedLeaves {
  public:
    /// All leaves. Throws base::Stopped where `stop` asked for it; what is here is of no use then.
    void project(const ListsModel& model, const base::View& view, const std::stop_token& stop);
    /// Those leaves again, which have moved; the view is as before. Gives where their triangles are or have been.
    [[nodiscard]] std::vector<TileRange> follow(const ListsModel& model, const base::View& view,
                                                std::span<const csg::LeafId> moved);

    /// Leaf by leaf.
    [[nodiscard]] const std::vector<ScreenTriangle>& triangles() const { return triangles_; }
    /// Calls action(first, end) for ranges of them that may reach those tiles, in order.
    template <typename Action>
    void for_each_near(const TileRange& tiles, const Action& action) const {
        std::size_t first = 0;
        for (std::size_t leaf = 0; leaf < counts_.size(); first += counts_[leaf++].triangles) {
            if (counts_[leaf].triangles > 0 && overlap(reach_[leaf], tiles)) {
                action(first, first + counts_[leaf].triangles);
            }
        }
    }
    /// By leaf: as PixelWalk wants them.
    [[nodiscard]] const std::vector<char>& counted_from_behind() const { return counted_from_behind_; }
    [[nodiscard]] const std::vector<char>& wound() const { return wound_; }
    /// Adds what is drawn and skipped.
    void count(ListsStats& stats) const;

  private:
    struct Count {
        bool drawn = false;
        std::uint32_t triangles = 0;  ///< Here.
        std::uint32_t skipped = 0;    ///< Of the leaf, which cover no sample.
    };
    /// Adds the leaf's triangles to `out`.
    void add(const ListsModel& model, const base::View& view, csg::LeafId id, std::vector<ScreenTriangle>& out);

    std::vector<ScreenTriangle> triangles_;
    std::vector<Count> counts_;     ///< By leaf, as are:
    std::vector<TileRange> reach_;  ///< The tiles that its triangles reach, or more.
    std::vector<char> counted_from_behind_, wound_;
};

}  // namespace goldfeather
