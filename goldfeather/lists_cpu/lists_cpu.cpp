#include "goldfeather/lists_cpu/lists_cpu.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "base/parallel.h"
#include "base/stop.h"
#include "csg/solid/part_order.h"
#include "goldfeather/lists_cpu/tile_worker.h"

namespace goldfeather {

namespace {

/// The tiles that the triangle's box reaches: first to last in x and y.
struct TileRange {
    int x0, y0, x1, y1;
};

TileRange tiles_of(const ScreenTriangle& t, glm::ivec2 tiles) {
    constexpr int kShift = kSubpixelBits + 5;
    static_assert(TileSpans::kSide == 1 << 5);
    const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
    return {std::max(x0 >> kShift, 0), std::max(y0 >> kShift, 0), std::min(x1 >> kShift, tiles.x - 1),
            std::min(y1 >> kShift, tiles.y - 1)};
}

/// Calls action(i) for the indices of so many things, and looks now and then whether it is to stop.
template <typename Action>
void for_each_until(std::size_t count, const std::stop_token& stop, const Action& action) {
    constexpr std::size_t kBetween = 4096;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % kBetween == 0) {
            base::end_if_asked(stop);
        }
        action(static_cast<std::uint32_t>(i));
    }
}

Bins make_bins(const std::vector<ScreenTriangle>& triangles, glm::ivec2 size, const std::stop_token& stop) {
    Bins bins;
    bins.tiles = (size + TileSpans::kSide - 1) / TileSpans::kSide;
    bins.starts.assign(static_cast<std::size_t>(bins.tiles.x) * static_cast<std::size_t>(bins.tiles.y) + 1, 0);
    const auto for_each_tile = [&](const ScreenTriangle& t, const auto& action) {
        const TileRange r = tiles_of(t, bins.tiles);
        for (int y = r.y0; y <= r.y1; ++y) {
            for (int x = r.x0; x <= r.x1; ++x) {
                action(static_cast<std::size_t>(y * bins.tiles.x + x));
            }
        }
    };
    for_each_until(triangles.size(), stop, [&](std::uint32_t i) {
        for_each_tile(triangles[i], [&](std::size_t tile) { ++bins.starts[tile + 1]; });
    });
    for (std::size_t i = 1; i < bins.starts.size(); ++i) {
        bins.starts[i] += bins.starts[i - 1];
    }
    bins.triangles.resize(bins.starts.back());
    std::vector<std::uint32_t> next(bins.starts.begin(), bins.starts.end() - 1);
    for_each_until(triangles.size(), stop, [&](std::uint32_t i) {
        for_each_tile(triangles[i], [&](std::size_t tile) { bins.triangles[next[tile]++] = i; });
    });
    return bins;
}

}  // namespace

void peel_lists(const ListsModel& model, const base::View& view, int max_layers, unsigned threads,
                layers::HostStack& out, ListsStats& stats, const std::stop_token& stop) {
    ListsJob job{model, view.size(), max_layers, out, stop};
    for (const csg::solid::Plane& plane : model.geometry.planes.planes()) {
        job.planes.push_back(view.exact_plane_depth(plane.normal, plane.offset));
    }
    job.ranks = csg::solid::ranks_of(csg::solid::part_order(model.scene, &model.geometry));
    const std::uint32_t drawn_before = stats.drawn_leaves;
    job.counted_from_behind.assign(model.geometry.leaves.size(), 0);
    job.wound.assign(model.geometry.leaves.size(), 0);
    for (csg::LeafId id = 0; id < model.geometry.leaves.size(); ++id) {
        base::end_if_asked(stop);
        const csg::solid::PlacedLeaf& leaf = model.geometry.leaves[id];
        if (leaf.box.empty() || is_hidden(model.scene, id) || view.screen_box(leaf.box.lo, leaf.box.hi).empty()) {
            ++stats.skipped_leaves;
            continue;
        }
        ++stats.drawn_leaves;
        job.counted_from_behind[id] = leaf.solid->closed && near_plane_cuts(view, leaf.box) ? 1 : 0;
        job.wound[id] = leaf.solid->winds() ? 1 : 0;
        const std::size_t before = job.triangles.size();
        project_leaf(leaf, id, view, job.triangles);
        // Clipping may make more of a triangle than one.
        const std::size_t kept = std::min(job.triangles.size() - before, leaf.triangles.size());
        stats.skipped_triangles += leaf.triangles.size() - kept;
    }
    job.bins = make_bins(job.triangles, job.size, stop);
    const int tiles = job.bins.tiles.x * job.bins.tiles.y;
    out.resize(view.size());

    std::atomic<int> next{0};
    std::atomic<bool> given_up{false};
    std::mutex adding;
    int most = 0;
    std::vector<char> seen(model.geometry.leaves.size(), 0);
    const auto work = [&] {
        TileWorker worker(job);
        for (int tile = next++; tile < tiles && !given_up && !stop.stop_requested(); tile = next++) {
            worker.run(tile);
        }
        const std::lock_guard lock(adding);
        most = std::max(most, worker.most_layers());
        std::transform(seen.begin(), seen.end(), worker.seen().begin(), seen.begin(),
                       [](char a, char b) { return static_cast<char>(a | b); });
        stats.fragments += worker.fragments();
        stats.longest_list = std::max(stats.longest_list, static_cast<std::uint32_t>(worker.longest_list()));
    };
    base::on_threads(threads, static_cast<unsigned>(std::max(tiles, 1)), work, [&] { given_up = true; });
    base::end_if_asked(stop);
    out.reserve(1);
    out.layers = std::max(most, 1);
    out.complete = max_layers == 0 || most < max_layers;
    stats.triangles = static_cast<std::uint32_t>(job.triangles.size());
    stats.occluded_leaves +=
        stats.drawn_leaves - drawn_before - static_cast<std::uint32_t>(std::count(seen.begin(), seen.end(), char{1}));
    stats.layers = std::max(stats.layers, most);
}

layers::HostStack peel_to_host(const csg::Scene& scene, const csg::solid::Geometry& geometry, const base::View& view,
                               int max_layers, unsigned threads) {
    layers::HostStack layers;
    ListsStats stats;
    peel_lists(ListsModel(scene, geometry), view, max_layers, threads, layers, stats);
    return layers;
}

void add(WalkStats& walk, const ListsStats& lists) {
    ++walk.passes;
    ++walk.bands;
    walk.fragments += lists.fragments;
    walk.drawn_leaves += lists.drawn_leaves;
    walk.skipped_leaves += lists.skipped_leaves;
    walk.skipped_triangles += lists.skipped_triangles;
    walk.occluded_leaves = walk.occluded_leaves.value_or(0) + lists.occluded_leaves;
    walk.longest_list = std::max(walk.longest_list, lists.longest_list);
    walk.layers = std::max(walk.layers, lists.layers);
}

}  // namespace goldfeather
