#include "goldfeather/lists_cpu.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <mutex>
#include <thread>

#include "goldfeather/pixel_walk.h"
#include "goldfeather/screen_triangles.h"
#include "goldfeather/tile_lists.h"

namespace goldfeather {

namespace {

/// Longer lists are made for fewer pixels at a time: the memory of a tile stays below 50 MB.
constexpr std::uint32_t kMostInWholeTile = 4096;

/// The triangles that reach each tile.
struct Bins {
    glm::ivec2 tiles{0};
    std::vector<std::uint32_t> starts;     ///< One more than tiles.
    std::vector<std::uint32_t> triangles;  ///< Indices, in order, tile after tile.

    [[nodiscard]] std::span<const std::uint32_t> of(int tile) const {
        const auto i = static_cast<std::size_t>(tile);
        return std::span(triangles).subspan(starts[i], starts[i + 1] - starts[i]);
    }
};

/// The tiles that the triangle's box reaches: first to last in x and y.
struct TileRange {
    int x0, y0, x1, y1;
};

TileRange tiles_of(const ScreenTriangle& t, glm::ivec2 tiles) {
    constexpr int kShift = kSubpixelBits + 5;
    static_assert(TileLists::kSide == 1 << 5);
    const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
    return {std::max(x0 >> kShift, 0), std::max(y0 >> kShift, 0), std::min(x1 >> kShift, tiles.x - 1),
            std::min(y1 >> kShift, tiles.y - 1)};
}

Bins make_bins(const std::vector<ScreenTriangle>& triangles, glm::ivec2 size) {
    Bins bins;
    bins.tiles = (size + TileLists::kSide - 1) / TileLists::kSide;
    bins.starts.assign(static_cast<std::size_t>(bins.tiles.x) * static_cast<std::size_t>(bins.tiles.y) + 1, 0);
    const auto for_each_tile = [&](const ScreenTriangle& t, const auto& action) {
        const TileRange r = tiles_of(t, bins.tiles);
        for (int y = r.y0; y <= r.y1; ++y) {
            for (int x = r.x0; x <= r.x1; ++x) {
                action(static_cast<std::size_t>(y * bins.tiles.x + x));
            }
        }
    };
    for (const ScreenTriangle& t : triangles) {
        for_each_tile(t, [&](std::size_t tile) { ++bins.starts[tile + 1]; });
    }
    for (std::size_t i = 1; i < bins.starts.size(); ++i) {
        bins.starts[i] += bins.starts[i - 1];
    }
    bins.triangles.resize(bins.starts.back());
    std::vector<std::uint32_t> next(bins.starts.begin(), bins.starts.end() - 1);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for_each_tile(triangles[i], [&](std::size_t tile) { bins.triangles[next[tile]++] = i; });
    }
    return bins;
}

/// What all threads share.
struct Job {
    const ListsModel& model;
    glm::ivec2 size;
    glm::dvec2 half;
    int max_layers;
    std::vector<ScreenTriangle> triangles;
    std::vector<gl::View::ExactPlaneDepth> planes;
    std::vector<char> counted_from_behind;
    Bins bins;
    CpuLayers& out;
    std::mutex growing;
    std::vector<int> tile_layers;  ///< The most layers of any pixel, by tile.
};

/// Where a thread writes one layer.
struct LayerTarget {
    float* depth;
    glm::uvec2* surface;
};

/// Makes planes for so many layers, and gives where all of them are.
std::vector<LayerTarget> reserve_layers(Job& job, std::size_t layers) {
    const std::lock_guard lock(job.growing);
    const std::size_t pixels = static_cast<std::size_t>(job.size.x) * static_cast<std::size_t>(job.size.y);
    while (job.out.planes.size() < layers) {
        job.out.planes.push_back({std::vector<float>(pixels), std::vector<glm::uvec2>(pixels)});
    }
    std::vector<LayerTarget> targets;
    for (CpuLayer& plane : job.out.planes) {
        targets.push_back({plane.depth.data(), plane.surface.data()});
    }
    return targets;
}

class TileWorker {
  public:
    explicit TileWorker(Job& job)
        : job_(job),
          lists_(job.planes, job.half),
          walk_(job.model.expressions, job.model.scene, job.counted_from_behind, job.max_layers) {}

    void run(int tile) {
        const int x = tile % job_.bins.tiles.x * TileLists::kSide, y = tile / job_.bins.tiles.x * TileLists::kSide;
        const TileBox box{x, y, std::min(x + TileLists::kSide, job_.size.x),
                          std::min(y + TileLists::kSide, job_.size.y)};
        most_layers_ = 0;
        const auto triangles = job_.bins.of(tile);
        if (!triangles.empty()) {
            fill(box, triangles);
            clear_below(box);
        }
        job_.tile_layers[static_cast<std::size_t>(tile)] = most_layers_;
    }

    [[nodiscard]] std::uint64_t fragments() const { return fragments_; }
    [[nodiscard]] std::uint32_t longest_list() const { return longest_list_; }

  private:
    void fill(const TileBox& box, std::span<const std::uint32_t> triangles) {
        const int width = box.x1 - box.x0, height = box.y1 - box.y0;
        const bool single = width == 1 && height == 1;
        const auto pixels = static_cast<std::uint32_t>(width * height);
        lists_.start(
            box, single ? std::numeric_limits<std::uint32_t>::max() : kMostInWholeTile * (TileLists::kPixels / pixels));
        for (const std::uint32_t t : triangles) {
            if (lists_.add(job_.triangles[t], t)) {
                continue;
            }
            // Too long for all pixels at once: in two halves.
            TileBox first = box, second = box;
            if (width >= height) {
                first.x1 = second.x0 = box.x0 + width / 2;
            } else {
                first.y1 = second.y0 = box.y0 + height / 2;
            }
            fill(first, triangles);
            fill(second, triangles);
            return;
        }
        for (int y = box.y0; y < box.y1; ++y) {
            for (int x = box.x0; x < box.x1; ++x) {
                pixel(x, y, TileLists::pixel_of(x - box.x0, y - box.y0));
            }
        }
    }

    void pixel(int x, int y, int at) {
        const std::uint32_t count = lists_.count(at);
        std::span<const FoundSurface> found;
        if (count > 0) {
            fragments_ += count;
            longest_list_ = std::max(longest_list_, count);
            sort(at, count);
            found = walk_.walk(sorted_);
            if (found.size() > targets_.size()) {
                targets_ = reserve_layers(job_, found.size());
            }
        }
        const std::size_t pixel = index_of(x, y);
        for (std::size_t layer = 0; layer < found.size(); ++layer) {
            const FoundSurface& s = found[layer];
            std::uint32_t plane = sorted_[s.first].plane;
            for (std::uint32_t i = s.first + 1; i < s.end; ++i) {
                plane = std::min(plane, sorted_[i].plane);
            }
            targets_[layer].depth[pixel] = static_cast<float>(std::clamp(sorted_[s.first].depth, 1e-30, 1.0));
            targets_[layer].surface[pixel] = {s.leaf << 1 | (s.reversed ? 1U : 0U), plane << 1 | (s.leaving ? 1U : 0U)};
        }
        layers_[static_cast<std::size_t>(TileLists::pixel_of(x % TileLists::kSide, y % TileLists::kSide))] =
            static_cast<int>(found.size());
        most_layers_ = std::max(most_layers_, static_cast<int>(found.size()));
    }

    /// Pixels with fewer layers than others of the tile have nothing in the rest.
    void clear_below(const TileBox& box) const {
        for (int y = box.y0; y < box.y1; ++y) {
            for (int x = box.x0; x < box.x1; ++x) {
                int layer =
                    layers_[static_cast<std::size_t>(TileLists::pixel_of(x % TileLists::kSide, y % TileLists::kSide))];
                for (; layer < most_layers_; ++layer) {
                    targets_[static_cast<std::size_t>(layer)].depth[index_of(x, y)] = 0;
                    targets_[static_cast<std::size_t>(layer)].surface[index_of(x, y)] = {kNoSurface, 0};
                }
            }
        }
    }

    [[nodiscard]] std::size_t index_of(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.size.x) + static_cast<std::size_t>(x);
    }

    /// The pixel's fragments, nearest first, into sorted_. Neighbouring pixels have theirs in much the same
    /// order, which is where the sort begins.
    void sort(int at, std::uint32_t count) {
        if (order_.size() != count) {
            order_.resize(count);
            for (std::uint32_t i = 0; i < count; ++i) {
                order_[i] = i;
            }
        }
        sorted_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t k = order_[i];
            const ScreenTriangle& t = job_.triangles[lists_.triangle(at, k)];
            const Fragment f{lists_.depth(at, k), t.leaf, t.plane};
            std::uint32_t j = i;
            for (; j > 0 && nearer(f, sorted_[j - 1]); --j) {
                sorted_[j] = sorted_[j - 1];
                order_[j] = order_[j - 1];
            }
            sorted_[j] = f;
            order_[j] = k;
        }
    }

    /// Equal depths in order of leaves, so that equal pixels have equal lists.
    static bool nearer(const Fragment& a, const Fragment& b) {
        return a.depth > b.depth || (a.depth == b.depth && a.leaf < b.leaf);
    }

    Job& job_;
    TileLists lists_;
    PixelWalk walk_;
    std::vector<Fragment> sorted_;
    std::vector<std::uint32_t> order_;
    std::vector<LayerTarget> targets_;
    std::array<int, TileLists::kPixels> layers_{};
    int most_layers_ = 0;
    std::uint64_t fragments_ = 0;
    std::uint32_t longest_list_ = 0;
};

/// Layers of tiles beyond what their worker wrote hold what was there before: nothing is to be seen there.
void clear_rest(Job& job, int layers) {
    for (int tile = 0; tile < job.bins.tiles.x * job.bins.tiles.y; ++tile) {
        const int x0 = tile % job.bins.tiles.x * TileLists::kSide, y0 = tile / job.bins.tiles.x * TileLists::kSide;
        const int width = std::min(TileLists::kSide, job.size.x - x0);
        for (int layer = job.tile_layers[static_cast<std::size_t>(tile)]; layer < layers; ++layer) {
            CpuLayer& plane = job.out.planes[static_cast<std::size_t>(layer)];
            for (int y = y0; y < std::min(y0 + TileLists::kSide, job.size.y); ++y) {
                const std::ptrdiff_t at = std::ptrdiff_t{y} * job.size.x + x0;
                std::fill_n(plane.depth.begin() + at, width, 0.0F);
                std::fill_n(plane.surface.begin() + at, width, glm::uvec2(kNoSurface, 0));
            }
        }
    }
}

}  // namespace

void peel_lists(const ListsModel& model, const gl::View& view, int max_layers, unsigned threads, CpuLayers& out,
                ListsStats& stats) {
    if (out.size != view.size()) {
        out = {};
        out.size = view.size();
    }
    Job job{model, view.size(), 0.5 * glm::dvec2(view.size()), max_layers, {}, {}, {}, {}, out, {}, {}};
    for (const csg::solid::Plane& plane : model.geometry.planes.planes()) {
        job.planes.push_back(view.exact_plane_depth(plane.normal, plane.offset));
    }
    job.counted_from_behind.assign(model.geometry.leaves.size(), 0);
    for (csg::LeafId id = 0; id < model.geometry.leaves.size(); ++id) {
        const csg::solid::PlacedLeaf& leaf = model.geometry.leaves[id];
        if (leaf.box.empty() || view.screen_box(leaf.box.lo, leaf.box.hi).empty()) {
            continue;
        }
        ++stats.drawn_leaves;
        job.counted_from_behind[id] = leaf.solid->closed && near_plane_cuts(view, leaf.box) ? 1 : 0;
        project_leaf(leaf, id, view, job.triangles);
    }
    job.bins = make_bins(job.triangles, job.size);
    const int tiles = job.bins.tiles.x * job.bins.tiles.y;
    job.tile_layers.assign(static_cast<std::size_t>(tiles), 0);
    (void)reserve_layers(job, 1);

    std::atomic<int> next{0};
    std::mutex adding;
    const auto work = [&] {
        TileWorker worker(job);
        for (int tile = next++; tile < tiles; tile = next++) {
            worker.run(tile);
        }
        const std::lock_guard lock(adding);
        stats.fragments += worker.fragments();
        stats.longest_list = std::max(stats.longest_list, worker.longest_list());
    };
    {
        std::vector<std::jthread> helpers;
        const unsigned wanted = threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
        for (unsigned i = 1; i < std::min(wanted, static_cast<unsigned>(tiles)); ++i) {
            helpers.emplace_back(work);
        }
        work();
    }
    const int most = *std::max_element(job.tile_layers.begin(), job.tile_layers.end());
    out.layers = std::max(most, 1);
    out.complete = max_layers == 0 || most < max_layers;
    clear_rest(job, out.layers);
    stats.triangles = static_cast<std::uint32_t>(job.triangles.size());
    stats.layers = std::max(stats.layers, most);
}

HostLayers to_host(const CpuLayers& layers) {
    HostLayers host{layers.size, layers.layers, {}};
    for (int layer = 0; layer < layers.layers; ++layer) {
        const CpuLayer& plane = layers.planes[static_cast<std::size_t>(layer)];
        for (std::size_t i = 0; i < plane.depth.size(); ++i) {
            const glm::uvec2 ids = plane.surface[i];
            host.surfaces.push_back(ids.x == kNoSurface ? Surface{}
                                                        : Surface{plane.depth[i], ids.x >> 1, ids.y >> 1,
                                                                  (ids.x & 1U) != 0, (ids.y & 1U) != 0});
        }
    }
    return host;
}

}  // namespace goldfeather
