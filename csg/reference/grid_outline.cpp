#include "csg/reference/grid_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "csg/reference/box_pairs.h"
#include "csg/solid/outline.h"
#include "csg/tree/finite.h"

namespace csg::reference {
namespace {

using Point = GridOutline::Point;
using Loop = GridOutline::Loop;

constexpr int kBits = 30;        // Of the larger side of the box.
constexpr double kRounding = 2;  // Cells: points and ends of edges are moved by half a cell's diagonal, 0.71, each.

/// Takes out what lies on the straight line between its neighbors, spikes too, unless `stays`.
template <typename Stays>
void straighten(Loop& loop, Stays&& stays) {
    for (std::size_t i = 0, kept = 0; loop.size() > 2 && kept < loop.size();) {
        const std::size_t n = loop.size();
        i %= n;
        if (turn(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]) != 0 || stays(loop[i])) {
            ++i;
            ++kept;
            continue;
        }
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
        i = (i + 2 * loop.size() - 2) % loop.size();  // Both neighbors have new ones.
        kept = 0;
    }
    if (loop.size() < 3) {
        loop.clear();
    }
}

struct Edge {
    Point from, to;
    std::size_t loop, index;  ///< The edge starts at this corner.
};

std::vector<Edge> edges_of(const std::vector<Loop>& loops) {
    std::vector<Edge> edges;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        for (std::size_t i = 0; i < loops[l].size(); ++i) {
            edges.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i});
        }
    }
    return edges;
}

int sign(std::int64_t value) {
    return (value > 0) - (value < 0);
}

bool cross(const Edge& a, const Edge& b) {
    return sign(turn(a.from, a.to, b.from)) * sign(turn(a.from, a.to, b.to)) < 0 &&
           sign(turn(b.from, b.to, a.from)) * sign(turn(b.from, b.to, a.to)) < 0;
}

/// Whether `p` is nearer to the edge than rounding may have moved both, and between its ends.
bool is_near(const Point& p, const Edge& e) {
    const glm::dvec2 way = e.to - e.from, q = p - e.from;
    const double along = glm::dot(way, q), length2 = glm::dot(way, way);
    const auto off = static_cast<double>(turn(e.from, e.to, p));
    return p != e.from && p != e.to && along > 0 && along < length2 && off * off <= kRounding * kRounding * length2;
}

/// A corner to be put on an edge.
struct Split {
    std::size_t loop, index;
    std::int64_t way;  ///< Grows from the edge's start to its end.
    Point at;

    [[nodiscard]] auto order() const { return std::tuple(loop, index, way, at.x, at.y); }
};

/// Where corners lie on edges or so near that rounding may have moved them off, in the order of the edges. Edges that
/// cross because they were rounded have one of their four ends near the other edge.
std::vector<Split> touching_corners(const std::vector<Edge>& edges) {
    std::vector<Box> boxes;
    boxes.reserve(edges.size());
    for (const Edge& e : edges) {
        boxes.push_back(enclose(enclose({}, {e.from, 0}), {e.to, 0}));
    }
    for (Box& box : boxes) {
        box.lo -= kRounding;
        box.hi += kRounding;
    }
    std::vector<Split> splits;
    const auto split = [&](const Edge& e, const Point& p) {
        const bool near = is_near(p, e);
        if (near) {
            splits.push_back({e.loop, e.index, std::abs(p.x - e.from.x) + std::abs(p.y - e.from.y), p});
        }
        return near;
    };
    BoxTree(boxes).pairs([&](std::size_t i, std::size_t j) {
        const Edge &a = edges[i], &b = edges[j];
        int near = 0;
        for (const Point& p : {b.from, b.to}) {
            near += split(a, p);
        }
        for (const Point& p : {a.from, a.to}) {
            near += split(b, p);
        }
        if (near == 0 && cross(a, b)) {
            throw std::runtime_error("outlines cross within the precision of the roof");
        }
    });
    const auto less = [](const Split& a, const Split& b) { return a.order() < b.order(); };
    const auto same = [](const Split& a, const Split& b) { return a.order() == b.order(); };
    std::sort(splits.begin(), splits.end(), less);
    splits.erase(std::unique(splits.begin(), splits.end(), same), splits.end());
    return splits;
}

std::vector<Loop> divided(const std::vector<Edge>& edges, const std::vector<Split>& splits, std::size_t loops) {
    std::vector<Loop> result(loops);
    auto next = splits.begin();
    for (const Edge& e : edges) {
        result[e.loop].push_back(e.from);
        for (; next != splits.end() && next->loop == e.loop && next->index == e.index; ++next) {
            result[e.loop].push_back(next->at);
        }
    }
    return result;
}

/// The edges without pairs of opposite ones: the region lies on both sides of them, or on neither.
std::vector<Edge> without_opposites(const std::vector<Edge>& edges) {
    std::map<std::array<std::int64_t, 4>, int> counts;  ///< From the first end in order to the second, less the others.
    const auto is_forward = [](const Edge& e) { return std::tie(e.from.x, e.from.y) < std::tie(e.to.x, e.to.y); };
    const auto count_of = [&](const Edge& e) -> int& {
        const auto [a, b] = is_forward(e) ? std::pair(e.from, e.to) : std::pair(e.to, e.from);
        return counts[{a.x, a.y, b.x, b.y}];
    };
    for (const Edge& e : edges) {
        count_of(e) += is_forward(e) ? 1 : -1;
    }
    std::vector<Edge> kept;
    for (const Edge& e : edges) {
        int& count = count_of(e);
        if (std::abs(count) > 1) {
            throw std::runtime_error("outlines overlap within the precision of the roof");
        }
        if (count == (is_forward(e) ? 1 : -1)) {
            kept.push_back(e);
            count = 0;
        }
    }
    return kept;
}

std::int64_t cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}

/// Whether direction `a` comes before `b` in a turn from `back` clockwise.
bool is_before(const Point& back, const Point& a, const Point& b) {
    const auto is_late = [&](const Point& d) { return cross(back, d) >= 0; };
    return is_late(a) != is_late(b) ? is_late(b) : cross(a, b) < 0;
}

/// The loops walked so that where they meet in a point each goes on along the edge that bounds the same part of the
/// region: a hole that touches a loop becomes part of it, and a loop that touches itself from outside becomes two.
std::vector<Loop> untangled(const std::vector<Edge>& edges) {
    std::multimap<std::pair<std::int64_t, std::int64_t>, std::size_t> leaving;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        leaving.emplace(std::pair(edges[e].from.x, edges[e].from.y), e);
    }
    const auto after = [&](const Edge& edge) {
        const auto [first, last] = leaving.equal_range({edge.to.x, edge.to.y});
        const auto way = [&](const auto& entry) { return edges[entry.second].to - edge.to; };
        return std::min_element(
                   first, last,
                   [&](const auto& a, const auto& b) { return is_before(edge.from - edge.to, way(a), way(b)); })
            ->second;
    };
    std::vector<Loop> result;
    std::vector<bool> used(edges.size());
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (used[start]) {
            continue;
        }
        Loop& loop = result.emplace_back();
        for (std::size_t e = start; !used[e]; e = after(edges[e])) {
            used[e] = true;
            loop.push_back(edges[e].from);
        }
        straighten(loop, [&](const Point& p) { return leaving.count({p.x, p.y}) > 1; });
    }
    std::erase_if(result, [](const Loop& loop) { return loop.empty(); });
    return result;
}

}  // namespace

GridOutline::GridOutline(std::span<const std::vector<glm::dvec2>> loops) {
    const Box box = solid::bounds_of(loops);
    const double side = std::max(box.size().x, box.size().y);
    if (!std::isfinite(side)) {
        throw std::runtime_error("an outline is not finite");
    }
    if (side == 0) {
        return;
    }
    center_ = box.center();
    scale_ = std::ldexp(1.0, kBits - 1 - std::ilogb(side));
    if (!std::isfinite(scale_)) {
        throw std::runtime_error("an outline is too small");
    }
    for (const auto& given : loops) {
        Loop loop;
        for (const glm::dvec2& p : given) {
            if (!is_finite(p)) {  // Boxes pass over these.
                throw std::runtime_error("an outline is not finite");
            }
            const Point q(std::llround((p.x - center_.x) * scale_), std::llround((p.y - center_.y) * scale_));
            origin_.try_emplace({q.x, q.y}, p);
            if (loop.empty() || loop.back() != q) {
                loop.push_back(q);
            }
        }
        straighten(loop, [](const Point&) { return false; });
        if (!loop.empty()) {
            loops_.push_back(std::move(loop));
        }
    }
    // Edges are bent where a corner near them is put on them, and may then meet others.
    constexpr int kMostRounds = 32;
    bool settled = false;
    for (int round = 0; !settled && round < kMostRounds; ++round) {
        const std::vector<Edge> edges = edges_of(loops_);
        const std::vector<Split> splits = touching_corners(edges);
        settled = splits.empty();
        if (!settled) {
            loops_ = divided(edges, splits, loops_.size());
        }
    }
    if (!settled) {
        throw std::runtime_error("outlines cross within the precision of the roof");
    }
    // Edges may be opposite ones only when points on straight lines, and spikes, are out.
    for (std::size_t before = 0, after = 1; before != after;) {
        const std::vector<Edge> edges = edges_of(loops_), kept = without_opposites(edges);
        before = edges.size();
        loops_ = untangled(kept);
        after = edges_of(loops_).size();
    }
}

}  // namespace csg::reference
