#include "goldfeather/lists_cpu/lists_cpu.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "base/stop.h"
#include "csg/solid/part_order.h"
#include "goldfeather/lists_cpu/tile_worker.h"

namespace goldfeather {

namespace {

/// Tiles that are to be filled.
struct WantedTiles {
    glm::ivec2 tiles{0};       ///< Of the picture.
    std::vector<char> wanted;  ///< Row by row.
    TileRange bounds;          ///< All of them lie in it.

    explicit WantedTiles(glm::ivec2 size) : tiles((size + TileSpans::kSide - 1) / TileSpans::kSide) {
        wanted.assign(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y), 0);
    }
    void add(const TileRange& range) {
        if (range.empty()) {
            return;
        }
        for (int y = range.from.y; y < range.to.y; ++y) {
            for (int x = range.from.x; x < range.to.x; ++x) {
                wanted[static_cast<std::size_t>(y * tiles.x + x)] = 1;
            }
        }
        bounds = bounds.empty() ? range : TileRange{glm::min(bounds.from, range.from), glm::max(bounds.to, range.to)};
    }
    [[nodiscard]] std::vector<int> list() const {
        std::vector<int> all;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (wanted[i] != 0) {
                all.push_back(static_cast<int>(i));
            }
        }
        return all;
    }
};

/// Of the triangles that reach those tiles. Looks now and then whether it is to stop.
Bins make_bins(const ProjectedLeaves& leaves, const WantedTiles& wanted, const std::stop_token& stop) {
    Bins bins;
    bins.tiles = wanted.tiles;
    bins.starts.assign(static_cast<std::size_t>(bins.tiles.x) * static_cast<std::size_t>(bins.tiles.y) + 1, 0);
    const std::vector<ScreenTriangle>& triangles = leaves.triangles();
    const auto for_each_tile = [&](const auto& action) {
        leaves.for_each_near(wanted.bounds, [&](std::size_t first, std::size_t end) {
            base::end_if_asked(stop);
            for (std::size_t i = first; i < end; ++i) {
                const TileRange r = tiles_of(triangles[i], bins.tiles);
                for (int y = r.from.y; y < r.to.y; ++y) {
                    for (int x = r.from.x; x < r.to.x; ++x) {
                        const auto tile = static_cast<std::size_t>(y * bins.tiles.x + x);
                        if (wanted.wanted[tile] != 0) {
                            action(tile, static_cast<std::uint32_t>(i));
                        }
                    }
                }
            }
        });
    };
    for_each_tile([&](std::size_t tile, std::uint32_t /*triangle*/) { ++bins.starts[tile + 1]; });
    for (std::size_t i = 1; i < bins.starts.size(); ++i) {
        bins.starts[i] += bins.starts[i - 1];
    }
    bins.triangles.resize(bins.starts.back());
    std::vector<std::uint32_t> next(bins.starts.begin(), bins.starts.end() - 1);
    for_each_tile([&](std::size_t tile, std::uint32_t triangle) { bins.triangles[next[tile]++] = triangle; });
    return bins;
}

std::vector<base::View::ExactPlaneDepth> plane_depths(const ListsModel& model, const base::View& view) {
    std::vector<base::View::ExactPlaneDepth> depths;
    depths.reserve(model.geometry.planes.planes().size());
    for (const csg::solid::Plane& plane : model.geometry.planes.planes()) {
        depths.push_back(view.exact_plane_depth(plane.normal, plane.offset));
    }
    return depths;
}

std::vector<std::uint32_t> part_ranks(const ListsModel& model) {
    return csg::solid::ranks_of(csg::solid::part_order(model.scene, &model.geometry));
}

/// Fills those tiles.
void peel_tiles(ListsJob& job, const WantedTiles& wanted, unsigned threads, ListsStats& stats) {
    job.bins = make_bins(job.leaves, wanted, job.stop);
    const std::vector<int> tiles = wanted.list();
    std::atomic<std::size_t> next{0};
    std::atomic<bool> given_up{false};
    std::mutex adding;
    std::vector<char> seen(job.model.geometry.leaves.size(), 0);
    const auto work = [&] {
        TileWorker worker(job);
        for (std::size_t i = next++; i < tiles.size() && !given_up && !job.stop.stop_requested(); i = next++) {
            worker.run(tiles[i]);
        }
        const std::lock_guard lock(adding);
        std::transform(seen.begin(), seen.end(), worker.seen().begin(), seen.begin(),
                       [](char a, char b) { return static_cast<char>(a | b); });
        stats.fragments += worker.fragments();
        stats.longest_list = std::max(stats.longest_list, static_cast<std::uint32_t>(worker.longest_list()));
    };
    base::on_threads(threads, static_cast<unsigned>(std::max<std::size_t>(tiles.size(), 1)), work,
                     [&] { given_up = true; });
    base::end_if_asked(job.stop);
    const std::uint32_t drawn_before = stats.drawn_leaves;
    job.leaves.count(stats);
    stats.triangles = static_cast<std::uint32_t>(job.leaves.triangles().size());
    stats.occluded_leaves +=
        stats.drawn_leaves - drawn_before - static_cast<std::uint32_t>(std::count(seen.begin(), seen.end(), char{1}));
    const int most = job.out.held.empty() ? 0 : *std::max_element(job.out.held.begin(), job.out.held.end());
    job.out.reserve(1);
    job.out.layers = std::max(most, 1);
    job.out.complete = job.max_layers == 0 || most < job.max_layers;
    stats.layers = std::max(stats.layers, most);
}

WantedTiles all_tiles(glm::ivec2 size) {
    WantedTiles all(size);
    all.add({{0, 0}, all.tiles});
    return all;
}

}  // namespace

void peel_lists(const ListsModel& model, const base::View& view, int max_layers, unsigned threads,
                layers::HostStack& out, ListsStats& stats, const std::stop_token& stop) {
    ProjectedLeaves leaves;
    leaves.project(model, view, stop);
    const auto planes = plane_depths(model, view);
    const auto ranks = part_ranks(model);
    out.resize(view.size());
    ListsJob job{model, view.size(), max_layers, out, stop, leaves, planes, ranks};
    peel_tiles(job, all_tiles(view.size()), threads, stats);
}

namespace {

bool same_view(const base::View& a, const base::View& b) {
    return a.size() == b.size() && a.jitter() == b.jitter() && a.camera() == b.camera() &&
           a.eye_from_world() == b.eye_from_world() && a.near_distance() == b.near_distance() &&
           a.far_distance() == b.far_distance() && a.half_height() == b.half_height();
}

}  // namespace

struct KeptLists::State {
    std::optional<base::View> view;  ///< That the stack was filled from; none: nothing is known of it.
    int max_layers = 0;
    ProjectedLeaves leaves;
    std::vector<base::View::ExactPlaneDepth> planes;
    std::vector<std::uint32_t> ranks;
    std::vector<char> hidden;  ///< By part.
    // Since then:
    std::vector<csg::LeafId> moved;
    std::vector<std::uint32_t> other_planes;

    [[nodiscard]] static std::vector<char> hidden_parts(const csg::Scene& scene) {
        std::vector<char> hidden;
        for (const csg::Part& part : scene.parts) {
            hidden.push_back(part.hidden ? 1 : 0);
        }
        return hidden;
    }
};

KeptLists::KeptLists() : state_(std::make_unique<State>()) {}
KeptLists::~KeptLists() = default;

void KeptLists::forget() {
    state_->view.reset();
}

void KeptLists::changed(const csg::solid::SceneChange& change) {
    if (change.structure || change.all_planes) {
        forget();
        return;
    }
    state_->moved.insert(state_->moved.end(), change.leaves.begin(), change.leaves.end());
    state_->other_planes.insert(state_->other_planes.end(), change.planes.begin(), change.planes.end());
}

void KeptLists::peel(const ListsModel& model, const base::View& view, int max_layers, unsigned threads,
                     layers::HostStack& out, ListsStats& stats, const std::stop_token& stop) {
    // Beyond that, the picture costs more than what is kept saves.
    constexpr std::size_t kMostMoved = 64, kMostTriangles = 4'000'000;
    State& s = *state_;
    std::sort(s.moved.begin(), s.moved.end());
    s.moved.erase(std::unique(s.moved.begin(), s.moved.end()), s.moved.end());
    std::vector<std::uint32_t> ranks = part_ranks(model);
    std::vector<char> hidden = State::hidden_parts(model.scene);
    const bool follows = s.view && same_view(*s.view, view) && s.max_layers == max_layers &&
                         s.moved.size() <= kMostMoved && s.ranks == ranks && s.hidden == hidden &&
                         out.size == view.size();
    s.view.reset();  // Until all of it is there.
    s.max_layers = max_layers;
    s.ranks = std::move(ranks);
    s.hidden = std::move(hidden);
    WantedTiles wanted(view.size());
    if (follows) {
        const auto& planes = model.geometry.planes.planes();
        const std::size_t known = s.planes.size();
        s.planes.resize(planes.size());
        for (std::size_t i = known; i < planes.size(); ++i) {
            s.planes[i] = view.exact_plane_depth(planes[i].normal, planes[i].offset);
        }
        for (const std::uint32_t i : s.other_planes) {
            if (i < planes.size()) {
                s.planes[i] = view.exact_plane_depth(planes[i].normal, planes[i].offset);
            }
        }
        for (const TileRange& touched : s.leaves.follow(model, view, s.moved)) {
            wanted.add(touched);
        }
    } else {
        s.planes = plane_depths(model, view);
        s.leaves.project(model, view, stop);
        out.resize(view.size());
        wanted = all_tiles(view.size());
    }
    s.moved.clear();
    s.other_planes.clear();
    ListsJob job{model, view.size(), max_layers, out, stop, s.leaves, s.planes, s.ranks};
    peel_tiles(job, wanted, threads, stats);
    if (s.leaves.triangles().size() <= kMostTriangles) {
        s.view = view;
    } else {
        s.leaves = {};
    }
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
