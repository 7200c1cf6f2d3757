#include "goldfeather/tile_worker.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace goldfeather {

namespace {

/// Longer lists are made for fewer pixels at a time: the memory of a tile stays below 50 MB.
constexpr std::uint32_t kMostInWholeTile = 4096;

/// Up to so many fragments, what was sorted for the pixel before is put right by insertion.
constexpr std::uint32_t kInsertion = 48;

/// Equal depths in order of leaves, so that equal pixels have equal lists.
bool nearer(const Fragment& a, const Fragment& b) {
    return a.depth > b.depth || (a.depth == b.depth && a.leaf < b.leaf);
}

int in_tile(int x, int y) {
    return TileLists::pixel_of(x % TileLists::kSide, y % TileLists::kSide);
}

}  // namespace

TileWorker::TileWorker(ListsJob& job)
    : job_(job),
      lists_(job.planes, 0.5 * glm::dvec2(job.size)),
      walk_(job.model.expressions, job.model.scene, job.counted_from_behind, job.max_layers) {}

void TileWorker::run(int tile) {
    const int x = tile % job_.bins.tiles.x * TileLists::kSide, y = tile / job_.bins.tiles.x * TileLists::kSide;
    const TileBox box{x, y, std::min(x + TileLists::kSide, job_.size.x), std::min(y + TileLists::kSide, job_.size.y)};
    tile_layers_ = 0;
    layers_.fill(0);
    const auto triangles = job_.bins.of(tile);
    if (!triangles.empty()) {
        fill(box, triangles);
    }
    int& held = job_.out.held[static_cast<std::size_t>(tile)];
    clear_below(box, std::max(held, tile_layers_));
    held = tile_layers_;
    most_layers_ = std::max(most_layers_, tile_layers_);
}

void TileWorker::fill(const TileBox& box, std::span<const std::uint32_t> triangles) {
    const int width = box.x1 - box.x0, height = box.y1 - box.y0;
    const auto pixels = static_cast<std::uint32_t>(width * height);
    lists_.start(box, pixels == 1 ? std::numeric_limits<std::uint32_t>::max()
                                  : kMostInWholeTile * (TileLists::kPixels / pixels));
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
        row(box, y);
    }
}

void TileWorker::row(const TileBox& box, int y) {
    const std::size_t picture_row = static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.size.x);
    for (int x = box.x0; x < box.x1;) {
        const int at = TileLists::pixel_of(x - box.x0, y - box.y0);
        const std::uint32_t count = lists_.count(at);
        if (count == 0) {
            ++x;
            continue;
        }
        int length = 1;
        while (x + length < box.x1 && lists_.same(at, at + length)) {
            ++length;
        }
        fragments_ += std::uint64_t{count} * static_cast<std::uint64_t>(length);
        longest_list_ = std::max(longest_list_, count);
        while (length > 0) {
            const int from = TileLists::pixel_of(x - box.x0, y - box.y0);
            const int drawn = draw({from, in_tile(x, y), picture_row + static_cast<std::size_t>(x), length}, count);
            x += drawn;
            length -= drawn;
        }
    }
}

int TileWorker::draw(const Run& run, std::uint32_t count) {
    sort(run.at, count);
    const auto found = walk_.walk(sorted_);
    int length = 1;
    while (length < run.length && same_order(run.at + length)) {
        ++length;
    }
    if (found.size() > targets_.size()) {
        reserve(found.size());
    }
    for (std::size_t layer = 0; layer < found.size(); ++layer) {
        const FoundSurface& s = found[layer];
        std::uint32_t plane = sorted_[s.first].plane;
        for (std::uint32_t i = s.first + 1; i < s.end; ++i) {
            plane = std::min(plane, sorted_[i].plane);
        }
        const double* from = lists_.depths(run.at, order_[s.first]);
        float* depth = targets_[layer].depth + run.target;
        for (int i = 0; i < length; ++i) {
            depth[i] = static_cast<float>(std::clamp(from[i], 1e-30, 1.0));
        }
        std::fill_n(targets_[layer].surface + run.target, length,
                    glm::uvec2(s.leaf << 1 | (s.reversed ? 1U : 0U), plane << 1 | (s.leaving ? 1U : 0U)));
    }
    const auto layers = static_cast<int>(found.size());
    std::fill_n(layers_.begin() + run.layers_at, length, layers);
    tile_layers_ = std::max(tile_layers_, layers);
    return length;
}

void TileWorker::sort(int at, std::uint32_t count) {
    if (order_.size() != count) {
        order_.resize(count);
        std::iota(order_.begin(), order_.end(), 0U);
    }
    sorted_.resize(count);
    const auto fragment = [&](std::uint32_t k) {
        const ScreenTriangle& t = job_.triangles[lists_.triangle(at, k)];
        return Fragment{*lists_.depths(at, k), t.leaf, t.plane};
    };
    if (count > kInsertion) {
        std::sort(order_.begin(), order_.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return nearer(fragment(a), fragment(b)); });
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t k = order_[i];
        const Fragment f = fragment(k);
        std::uint32_t j = i;
        for (; j > 0 && nearer(f, sorted_[j - 1]); --j) {
            sorted_[j] = sorted_[j - 1];
            order_[j] = order_[j - 1];
        }
        sorted_[j] = f;
        order_[j] = k;
    }
}

/// Are the fragments of this pixel, which has the triangles of the one sorted last, in the order of that one, with the
/// same events?
bool TileWorker::same_order(int at) const {
    double before = *lists_.depths(at, order_[0]);
    for (std::size_t i = 1; i < order_.size(); ++i) {
        const double depth = *lists_.depths(at, order_[i]);
        if (sorted_[i].depth == sorted_[i - 1].depth ? depth != before : !(depth < before)) {
            return false;
        }
        before = depth;
    }
    return true;
}

/// Pixels with fewer layers have nothing in the rest of `layers`.
void TileWorker::clear_below(const TileBox& box, int layers) {
    reserve(static_cast<std::size_t>(layers));
    for (int layer = 0; layer < layers; ++layer) {
        const Target& target = targets_[static_cast<std::size_t>(layer)];
        for (int y = box.y0; y < box.y1; ++y) {
            const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.size.x);
            for (int x = box.x0; x < box.x1; ++x) {
                if (layers_[static_cast<std::size_t>(in_tile(x, y))] <= layer) {
                    target.depth[row + static_cast<std::size_t>(x)] = 0;
                    target.surface[row + static_cast<std::size_t>(x)] = {kNoSurface, 0};
                }
            }
        }
    }
}

/// Makes layers, which other threads may do as well, and notes where they are.
void TileWorker::reserve(std::size_t layers) {
    if (layers <= targets_.size()) {
        return;
    }
    const std::lock_guard lock(job_.growing);
    const std::size_t pixels = static_cast<std::size_t>(job_.size.x) * static_cast<std::size_t>(job_.size.y);
    auto& planes = job_.out.planes;
    while (planes.size() < layers) {
        planes.push_back({std::vector<float>(pixels), std::vector<glm::uvec2>(pixels, {kNoSurface, 0})});
    }
    targets_.clear();
    for (CpuLayer& plane : planes) {
        targets_.push_back({plane.depth.data(), plane.surface.data()});
    }
}

}  // namespace goldfeather
