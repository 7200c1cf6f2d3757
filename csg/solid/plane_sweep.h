// A sweep from left to right over edges that meet in their ends only.
#pragma once

#include <cstdint>
#include <iterator>
#include <set>
#include <span>
#include <vector>

#include "csg/solid/grid_point.h"

namespace csg::solid {

inline constexpr std::uint32_t kNoEdge = 0xffffffff;

/// A point where edges end or begin; edges by their indices, bottom to top.
struct SweepVertex {
    GridPoint at;
    std::span<const std::uint32_t> left, right;
    std::uint32_t below, above;  ///< The nearest edges that pass by; kNoEdge where there is none.
};

/// Calls `visit` for each end of `edges` (sorted by a, then b) in ascending order; `visit` returns false to give up.
/// False where it did, or where edges conflict (Shamos and Hoey 1976: the first place where edges meet is between
/// neighbors). In time O(n log n).
template <typename Visit>
[[nodiscard]] bool sweep(std::span<const GridEdge> edges, Visit&& visit) {
    const auto below = [&](std::uint32_t e, std::uint32_t f) { return is_below(edges[e], edges[f]); };
    using Status = std::set<std::uint32_t, decltype(below)>;
    Status status(below);
    std::vector<typename Status::iterator> place(edges.size());
    std::vector<std::uint32_t> by_end(edges.size()), left, right;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        by_end[i] = i;
    }
    std::sort(by_end.begin(), by_end.end(), [&](std::uint32_t e, std::uint32_t f) {
        return edges[e].b != edges[f].b ? edges[e].b < edges[f].b : e < f;
    });
    const auto clash = [&](std::uint32_t e, std::uint32_t f) {
        return e != kNoEdge && f != kNoEdge && conflict(edges[e], edges[f]);
    };
    for (std::size_t begun = 0, ended = 0; ended < edges.size();) {
        SweepVertex vertex{};
        vertex.at = edges[by_end[ended]].b;
        if (begun < edges.size()) {
            vertex.at = std::min(vertex.at, edges[begun].a);
        }
        left.clear();
        right.clear();
        for (; ended < edges.size() && edges[by_end[ended]].b == vertex.at; ++ended) {
            left.push_back(by_end[ended]);
        }
        for (; begun < edges.size() && edges[begun].a == vertex.at; ++begun) {
            right.push_back(static_cast<std::uint32_t>(begun));
        }
        std::sort(left.begin(), left.end(), below);
        std::sort(right.begin(), right.end(), below);
        auto next = status.end();
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (i > 0 && next != place[left[i]]) {
                return false;  // Something lies between edges that meet here.
            }
            next = status.erase(place[left[i]]);
        }
        for (const std::uint32_t e : right) {
            const std::size_t before = status.size();
            place[e] = left.empty() && e == right.front() ? status.insert(e).first : status.emplace_hint(next, e);
            if (status.size() == before) {
                return false;
            }
            next = std::next(place[e]);
        }
        if (left.empty() && right.empty()) {
            return false;
        }
        vertex.above = next == status.end() ? kNoEdge : *next;
        auto first = right.empty() ? next : place[right.front()];
        vertex.below = first == status.begin() ? kNoEdge : *std::prev(first);
        if (right.empty() ? clash(vertex.below, vertex.above)
                          : clash(vertex.below, right.front()) || clash(right.back(), vertex.above)) {
            return false;
        }
        for (std::size_t i = 1; i < right.size(); ++i) {
            if (clash(right[i - 1], right[i]) || std::next(place[right[i - 1]]) != place[right[i]]) {
                return false;
            }
        }
        vertex.left = left;
        vertex.right = right;
        if (!visit(vertex)) {
            return false;
        }
    }
    return true;
}

}  // namespace csg::solid
