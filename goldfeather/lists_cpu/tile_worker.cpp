#include "goldfeather/lists_cpu/tile_worker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace goldfeather {

namespace {

/// Spans of a tile; one with more is split. That bounds the memory of a thread to a few tens of MB, except in a row of
/// a tile that more triangles cross than that.
constexpr std::size_t kMostSpans = std::size_t{1} << 21;

/// So many new fragments are put in by insertion.
constexpr std::size_t kInsertion = 32;

/// Of so many new fragments, that of a leaf is looked for one by one.
constexpr std::size_t kFew = 8;

/// In place of a slot: the fragment has taken another's place.
constexpr std::uint32_t kTaken = std::numeric_limits<std::uint32_t>::max();
constexpr csg::LeafId kNoLeaf = std::numeric_limits<csg::LeafId>::max();

static_assert(TileSpans::kSide == layers::HostStack::kTileSide);

/// Equal depths in order of leaves, so that equal pixels have equal lists.
bool nearer(const Fragment& a, const Fragment& b) {
    return a.depth > b.depth || (a.depth == b.depth && a.leaf_and_side < b.leaf_and_side);
}

int in_tile(int x, int y) {
    return TileSpans::pixel_of(x % TileSpans::kSide, y % TileSpans::kSide);
}

}  // namespace

TileWorker::TileWorker(ListsJob& job)
    : job_(job),
      half_width_(0.5 * job.size.x),
      half_height_(0.5 * job.size.y),
      spans_(job.leaves.triangles()),
      walk_(job.model.expressions, job.model.scene, job.ranks, job.leaves.counted_from_behind(), job.leaves.wound(),
            job.max_layers),
      seen_(job.model.geometry.leaves.size(), 0) {}

void TileWorker::run(int tile) {
    const int x = tile % job_.bins.tiles.x * TileSpans::kSide, y = tile / job_.bins.tiles.x * TileSpans::kSide;
    const TileBox box{x, y, std::min(x + TileSpans::kSide, job_.size.x), std::min(y + TileSpans::kSide, job_.size.y)};
    tile_layers_ = 0;
    layers_.fill(0);
    const auto triangles = job_.bins.of(tile);
    if (!triangles.empty()) {
        fill(box, triangles);
    }
    int& held = job_.out.held[static_cast<std::size_t>(tile)];
    if (job_.stop.stop_requested()) {
        give_up(box);
        held = room();
        return;
    }
    if (std::max(held, tile_layers_) > 0) {
        reserve(static_cast<std::size_t>(std::max(held, tile_layers_)));
        count_layers(box);
    }
    held = tile_layers_;
}

void TileWorker::fill(const TileBox& box, std::span<const std::uint32_t> triangles) {
    const int height = box.y1 - box.y0;
    spans_.start(box, height == 1 ? std::numeric_limits<std::size_t>::max() : kMostSpans);
    for (const std::uint32_t t : triangles) {
        if (job_.stop.stop_requested()) {
            return;
        }
        if (spans_.add(t)) {
            continue;
        }
        TileBox first = box, second = box;
        first.y1 = second.y0 = box.y0 + height / 2;
        fill(first, triangles);
        fill(second, triangles);
        return;
    }
    for (int y = box.y0; y < box.y1 && !job_.stop.stop_requested(); ++y) {
        row(box, y);
    }
}

/// What has been written is not known any more: the next picture is to clear all of it.
void TileWorker::give_up(const TileBox& box) {
    for (int y = box.y0; y < box.y1; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(y) * job_.size.x;
        std::fill(job_.out.counts.begin() + row + box.x0, job_.out.counts.begin() + row + box.x1, room());
    }
}

int TileWorker::room() const {
    const std::lock_guard lock(job_.growing);
    return static_cast<int>(job_.out.planes.size());
}

void TileWorker::row(const TileBox& box, int y) {
    sorted_.clear();
    slots_.clear();
    const int row = y - box.y0;
    for (std::uint32_t bounds = spans_.bounds(row); bounds != 0;) {
        const int at = std::countr_zero(bounds);
        bounds &= bounds - 1;
        const int end = bounds != 0 ? std::countr_zero(bounds) : box.x1 - box.x0;
        spans_.for_each_from(row, at, [&](std::uint32_t triangle, int last) { enter(triangle, last, y); });
        for (int from = at; from < end;) {
            advance(box.x0 + from, from);
            if (sorted_.empty()) {
                break;
            }
            const int length = same_order(box.x0 + from, end - from);
            write(box.x0 + from, y, length);
            fragments_ += sorted_.size() * static_cast<std::uint64_t>(length);
            longest_list_ = std::max(longest_list_, sorted_.size());
            from += length;
        }
    }
}

void TileWorker::enter(std::uint32_t triangle, int last, int y) {
    const ScreenTriangle& t = job_.leaves.triangles()[triangle];
    const base::View::ExactPlaneDepth& plane = job_.planes[t.plane];
    // Snapping has moved the border by up to 2⁻¹⁴ pixel: a sample there must not be thrown far along a steep plane.
    const double slack = std::min(0x1p-13 * (std::abs(plane.a) + std::abs(plane.b)), 0.25 * (t.nearest - t.farthest)) +
                         1e-12 * t.nearest;
    const double base = plane.edge_on ? 0.5 * (t.farthest + t.nearest)
                                      : plane.b * (static_cast<double>(y) + 0.5 - half_height_) + plane.c;
    entering_.push_back({0, t.leaf_and_side, t.plane, static_cast<std::uint32_t>(slots_.size())});
    slots_.push_back({plane.edge_on ? 0 : plane.a, base, t.farthest - slack, t.nearest + slack, last});
}

double TileWorker::depth(const Slot& slot, double sample) {
    return std::min(std::max(slot.slope * sample + slot.base, slot.least), slot.most);
}

void TileWorker::advance(int x, int at) {
    // A leaf's triangle mostly takes the place of its neighbor.
    // Field by field: a fragment copied right after its depth was stored would wait for the store.
    const double sample = static_cast<double>(x) + 0.5 - half_width_;
    if (entering_.size() > kFew) {
        index_entering();
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
        Fragment from = sorted_[i];
        if (slots_[from.slot].last < at && !take_entering(from)) {
            continue;
        }
        Fragment& to = sorted_[kept++];
        to.depth = depth(slots_[from.slot], sample);
        to.leaf_and_side = from.leaf_and_side;
        to.plane = from.plane;
        to.slot = from.slot;
    }
    sorted_.resize(kept);
    std::size_t entered = 0;
    for (const Fragment& f : entering_) {
        if (f.slot != kTaken) {
            sorted_.push_back({depth(slots_[f.slot], sample), f.leaf_and_side, f.plane, f.slot});
            ++entered;
        }
    }
    forget_entering();
    sort(entered);
}

/// Few are searched one by one, many by an index.
void TileWorker::index_entering() {
    entering_of_.resize(job_.model.geometry.leaves.size(), 0);
    for (std::size_t i = 0; i < entering_.size(); ++i) {
        entering_of_[entering_[i].leaf()] = static_cast<std::uint32_t>(i + 1);
    }
}

/// Replaces `f`, whose span has ended, by one of its leaf's whose span begins, if there is any.
bool TileWorker::take_entering(Fragment& f) {
    if (entering_.size() > kFew) {
        std::uint32_t& place = entering_of_[f.leaf()];
        if (place == 0) {
            return false;
        }
        f = std::exchange(entering_[place - 1], {0, f.leaf_and_side, 0, kTaken});
        place = 0;
        return true;
    }
    const auto next = std::find_if(entering_.begin(), entering_.end(),
                                   [&](const Fragment& e) { return e.leaf_and_side == f.leaf_and_side; });
    if (next == entering_.end()) {
        return false;
    }
    f = *next;
    next->slot = kTaken;
    next->leaf_and_side = kNoLeaf;
    return true;
}

void TileWorker::forget_entering() {
    if (entering_.size() > kFew) {
        for (const Fragment& f : entering_) {
            entering_of_[f.leaf()] = 0;
        }
    }
    entering_.clear();
}

/// By insertion, since most stand where they should; where that takes too many steps, from the start.
void TileWorker::sort(std::size_t entered) {
    std::size_t steps = entered > kInsertion ? 0 : 4 * sorted_.size() + kInsertion * kInsertion;
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
        if (!nearer(sorted_[i], sorted_[i - 1])) {
            continue;
        }
        const Fragment f = sorted_[i];
        std::size_t j = i;
        for (; j > 0 && nearer(f, sorted_[j - 1]); --j) {
            sorted_[j] = sorted_[j - 1];
        }
        sorted_[j] = f;
        if (i - j > steps) {
            std::sort(sorted_.begin(), sorted_.end(), nearer);
            return;
        }
        steps -= i - j;
    }
}

/// Depths are affine along the row: an order that holds at both ends holds between them.
int TileWorker::same_order(int x, int length) const {
    int same = 1, other = length + 1;
    for (int test = length; other - same > 1; test = (same + other) / 2) {
        (same_order(x + test - 1) ? same : other) = test;
    }
    return same;
}

bool TileWorker::same_order(int x) const {
    const double sample = static_cast<double>(x) + 0.5 - half_width_;
    double before = depth(slots_[sorted_[0].slot], sample);
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
        const double here = depth(slots_[sorted_[i].slot], sample);
        if (sorted_[i].depth == sorted_[i - 1].depth ? here != before : !(here < before)) {
            return false;
        }
        before = here;
    }
    return true;
}

void TileWorker::write(int x, int y, int length) {
    const auto found = walk_.walk(sorted_);
    if (found.size() > targets_.size()) {
        reserve(found.size());
    }
    const std::size_t target =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.size.x) + static_cast<std::size_t>(x);
    for (std::size_t layer = 0; layer < found.size(); ++layer) {
        const FoundSurface& s = found[layer];
        seen_[s.leaf] = 1;
        std::uint32_t plane = sorted_[s.first].plane;
        for (std::uint32_t i = s.first + 1; i < s.end; ++i) {
            plane = std::min(plane, sorted_[i].plane);
        }
        const Slot slot = slots_[sorted_[s.first].slot];
        float* depths = targets_[layer].depth + target;
        for (int i = 0; i < length; ++i) {
            const double at = depth(slot, static_cast<double>(x + i) + 0.5 - half_width_);
            depths[i] = static_cast<float>(std::min(std::max(at, 1e-30), 1.0));
        }
        std::fill_n(targets_[layer].surface + target, length,
                    layers::encode({0, s.leaf, plane, s.reversed, s.leaving}));
    }
    const auto layers = static_cast<int>(found.size());
    std::fill_n(layers_.begin() + in_tile(x, y), length, layers);
    tile_layers_ = std::max(tile_layers_, layers);
}

/// Notes how many layers each pixel has, and takes away what it had below them in the picture before.
void TileWorker::count_layers(const TileBox& box) {
    for (int y = box.y0; y < box.y1; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.size.x);
        for (int x = box.x0; x < box.x1; ++x) {
            const std::size_t pixel = row + static_cast<std::size_t>(x);
            const int before = std::exchange(job_.out.counts[pixel], layers_[static_cast<std::size_t>(in_tile(x, y))]);
            clear(pixel, job_.out.counts[pixel], before);
        }
    }
}

void TileWorker::clear(std::size_t pixel, int first, int end) {
    for (int layer = first; layer < end; ++layer) {
        const Target& target = targets_[static_cast<std::size_t>(layer)];
        target.depth[pixel] = 0;
        target.surface[pixel] = {layers::kNoSurface, 0};
    }
}

/// Makes layers, which other threads may do as well, and notes where they are.
void TileWorker::reserve(std::size_t layers) {
    if (layers <= targets_.size()) {
        return;
    }
    const std::lock_guard lock(job_.growing);
    job_.out.reserve(layers);
    targets_.clear();
    for (layers::HostLayer& plane : job_.out.planes) {
        targets_.push_back({plane.depth.data(), plane.surface.data()});
    }
}

}  // namespace goldfeather
