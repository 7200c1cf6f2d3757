#include "npr/sorted/index_sort.h"

#include <algorithm>
#include <numeric>

namespace npr {
namespace {

/// Does a stand before b?
bool before(std::uint32_t a, std::uint32_t b, std::span<const double> keys) {
    return keys[a] != keys[b] ? keys[a] > keys[b] : a < b;
}

/// Merges sorted halves, and counts what passes each other.
std::uint64_t merge(std::span<std::uint32_t> order, std::span<std::uint32_t> room, std::span<const double> keys) {
    if (order.size() < 2) {
        return 0;
    }
    const std::size_t half = order.size() / 2;
    std::uint64_t count = merge(order.first(half), room, keys) + merge(order.subspan(half), room, keys);
    std::size_t left = 0, right = half;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool take_left = right == order.size() || (left < half && !before(order[right], order[left], keys));
        count += take_left ? 0 : half - left;
        room[i] = order[take_left ? left++ : right++];
    }
    std::copy_n(room.begin(), order.size(), order.begin());
    return count;
}

}  // namespace

std::uint64_t inversions(std::vector<std::uint32_t> order, std::span<const double> keys) {
    std::vector<std::uint32_t> room(order.size());
    return merge(order, room, keys);
}

SortCount IndexSort::sort(std::span<const double> keys) {
    SortCount count;
    std::vector<std::uint32_t> as_given(keys.size());
    std::iota(as_given.begin(), as_given.end(), 0U);
    count.from_nothing = inversions(as_given, keys);
    if (order_.size() != keys.size()) {
        order_ = as_given;
    }
    // By insertion while it is quicker than sorting anew: most frames are nearly in order.
    const std::uint64_t most = 64 * static_cast<std::uint64_t>(keys.size());
    for (std::size_t i = 1; i < order_.size() && count.swaps <= most; ++i) {
        const std::uint32_t moved = order_[i];
        std::size_t to = i;
        for (; to > 0 && before(moved, order_[to - 1], keys); --to) {
            order_[to] = order_[to - 1];
        }
        order_[to] = moved;
        count.swaps += i - to;
    }
    if (count.swaps > most) {
        count.swaps += inversions(order_, keys);
        std::sort(order_.begin(), order_.end(), [&](auto a, auto b) { return before(a, b, keys); });
    }
    return count;
}

}  // namespace npr
