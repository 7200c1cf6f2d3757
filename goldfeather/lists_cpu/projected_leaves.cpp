#include "goldfeather/lists_cpu/projected_leaves.h"

#include <algorithm>
#include <numeric>

#include "base/stop.h"
#include "goldfeather/lists_cpu/tile_spans.h"

namespace goldfeather {

TileRange tiles_of(const ScreenTriangle& t, glm::ivec2 tiles) {
    constexpr int kShift = kSubpixelBits + 5;
    static_assert(TileSpans::kSide == 1 << 5);
    const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
    return {{std::max(x0 >> kShift, 0), std::max(y0 >> kShift, 0)},
            {std::min((x1 >> kShift) + 1, tiles.x), std::min((y1 >> kShift) + 1, tiles.y)}};
}

void ProjectedLeaves::add(const ListsModel& model, const base::View& view, csg::LeafId id,
                          std::vector<ScreenTriangle>& out) {
    const csg::solid::PlacedLeaf& leaf = model.geometry.leaves[id];
    counted_from_behind_[id] = wound_[id] = 0;
    counts_[id] = {};
    reach_[id] = {};
    const base::View::Rectangle box =
        leaf.box.empty() ? base::View::Rectangle{} : view.screen_box(leaf.box.lo, leaf.box.hi);
    if (box.empty() || is_hidden(model.scene, id)) {
        return;
    }
    counted_from_behind_[id] = leaf.solid->closed && near_plane_cuts(view, leaf.box) ? 1 : 0;
    wound_[id] = leaf.solid->winds() ? 1 : 0;
    const std::size_t before = out.size();
    project_leaf(leaf, id, view, out);
    const std::size_t added = out.size() - before;
    // Clipping may make more of a triangle than one.
    const std::size_t kept = std::min(added, leaf.triangles.size());
    counts_[id] = {true, static_cast<std::uint32_t>(added), static_cast<std::uint32_t>(leaf.triangles.size() - kept)};
    constexpr int kSide = TileSpans::kSide;
    reach_[id] = {{box.x0 / kSide, box.y0 / kSide}, {(box.x1 - 1) / kSide + 1, (box.y1 - 1) / kSide + 1}};
}

void ProjectedLeaves::project(const ListsModel& model, const base::View& view, const std::stop_token& stop) {
    const std::size_t leaves = model.geometry.leaves.size();
    triangles_.clear();
    counts_.resize(leaves);
    reach_.resize(leaves);
    counted_from_behind_.resize(leaves);
    wound_.resize(leaves);
    for (csg::LeafId id = 0; id < leaves; ++id) {
        base::end_if_asked(stop);
        add(model, view, id, triangles_);
    }
}

std::vector<TileRange> ProjectedLeaves::follow(const ListsModel& model, const base::View& view,
                                               std::span<const csg::LeafId> moved) {
    std::vector<TileRange> touched;
    std::vector<ScreenTriangle> now;
    for (const csg::LeafId id : moved) {
        const std::size_t first = std::accumulate(counts_.begin(), counts_.begin() + id, std::size_t{0},
                                                  [](std::size_t sum, const Count& c) { return sum + c.triangles; });
        const std::size_t before = counts_[id].triangles;
        touched.push_back(reach_[id]);
        now.clear();
        add(model, view, id, now);
        touched.push_back(reach_[id]);
        const std::size_t common = std::min(before, now.size());
        const auto at = triangles_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = std::copy_n(now.begin(), common, at);
        if (now.size() > before) {
            triangles_.insert(end, now.begin() + static_cast<std::ptrdiff_t>(common), now.end());
        } else {
            triangles_.erase(end, at + static_cast<std::ptrdiff_t>(before));
        }
    }
    return touched;
}

void ProjectedLeaves::count(ListsStats& stats) const {
    for (const Count& count : counts_) {
        ++(count.drawn ? stats.drawn_leaves : stats.skipped_leaves);
        stats.skipped_triangles += count.skipped;
    }
}

}  // namespace goldfeather
