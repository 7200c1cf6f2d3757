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

constexpr int kBits = 30;  // Of the larger side of the box.

/// Takes out what lies on the straight line between its neighbours, spikes too, unless `stays`.
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
        i = (i + 2 * loop.size() - 2) % loop.size();  // Both neighbours have new ones.
        kept = 0;
    }
    if (loop.size() < 3)
        loop.clear();
}

struct Edge {
    Point from, to;
    std::size_t loop, index;  ///< The edge starts at this corner.
};

std::vector<Edge> edges_of(const std::vector<Loop>& loops) {
    std::vector<Edge> edges;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        for (std::size_t i = 0; i < loops[l].size(); ++i)
            edges.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i});
    }
    return edges;
}

int sign(std::int64_t value) {
    return (value > 0) - (value < 0);
}

/// On the edge, but not at its ends.
bool is_within(const Point& p, const Edge& e) {
    return p != e.from && p != e.to && turn(e.from, e.to, p) == 0 && std::min(e.from.x, e.to.x) <= p.x &&
           p.x <= std::max(e.from.x, e.to.x) && std::min(e.from.y, e.to.y) <= p.y && p.y <= std::max(e.from.y, e.to.y);
}

bool cross(const Edge& a, const Edge& b) {
    return sign(turn(a.from, a.to, b.from)) * sign(turn(a.from, a.to, b.to)) < 0 &&
           sign(turn(b.from, b.to, a.from)) * sign(turn(b.from, b.to, a.to)) < 0;
}

/// A corner to be put on an edge.
struct Split {
    std::size_t loop, index;
    std::int64_t way;  ///< Grows from the edge's start to its end.
    Point at;

    [[nodiscard]] auto order() const { return std::tuple(loop, index, way, at.x, at.y); }
};

/// Where corners lie on edges, in the order of the edges.
std::vector<Split> touching_corners(const std::vector<Edge>& edges) {
    std::vector<Box> boxes;
    for (const Edge& e : edges)
        boxes.push_back(enclose(enclose({}, {e.from, 0}), {e.to, 0}));
    std::vector<Split> splits;
    const auto split = [&](const Edge& e, const Point& p) {
        if (is_within(p, e))
            splits.push_back({e.loop, e.index, std::abs(p.x - e.from.x) + std::abs(p.y - e.from.y), p});
    };
    BoxTree(boxes).pairs([&](std::size_t i, std::size_t j) {
        const Edge &a = edges[i], &b = edges[j];
        if (cross(a, b))
            throw std::runtime_error("outlines cross within the precision of the roof");
        split(a, b.from);
        split(b, a.from);
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
        for (; next != splits.end() && next->loop == e.loop && next->index == e.index; ++next)
            result[e.loop].push_back(next->at);
    }
    return result;
}

/// The edges without pairs of opposite ones: the region lies on both sides of them, or on neither.
std::vector<Edge> without_opposites(const std::vector<Edge>& edges) {
    std::map<std::array<std::int64_t, 4>, std::size_t> known;
    std::vector<bool> gone(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Point &from = edges[e].from, &to = edges[e].to;
        if (const auto opposite = known.find({to.x, to.y, from.x, from.y}); opposite != known.end()) {
            gone[e] = gone[opposite->second] = true;
            known.erase(opposite);
        } else if (!known.try_emplace({from.x, from.y, to.x, to.y}, e).second) {
            throw std::runtime_error("outlines overlap within the precision of the roof");
        }
    }
    std::vector<Edge> kept;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (!gone[e])
            kept.push_back(edges[e]);
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
    for (std::size_t e = 0; e < edges.size(); ++e)
        leaving.emplace(std::pair(edges[e].from.x, edges[e].from.y), e);
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
        if (used[start])
            continue;
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
    if (!std::isfinite(side))
        throw std::runtime_error("an outline is not finite");
    if (side == 0)
        return;
    centre_ = box.centre();
    scale_ = std::ldexp(1.0, kBits - 1 - std::ilogb(side));
    if (!std::isfinite(scale_))
        throw std::runtime_error("an outline is too small");
    for (const auto& given : loops) {
        Loop loop;
        for (const glm::dvec2& p : given) {
            if (!is_finite(p))  // Boxes pass over these.
                throw std::runtime_error("an outline is not finite");
            const Point q(std::llround((p.x - centre_.x) * scale_), std::llround((p.y - centre_.y) * scale_));
            origin_.try_emplace({q.x, q.y}, p);
            if (loop.empty() || loop.back() != q)
                loop.push_back(q);
        }
        straighten(loop, [](const Point&) { return false; });
        if (!loop.empty())
            loops_.push_back(std::move(loop));
    }
    const std::vector<Edge> edges = edges_of(loops_);
    if (const std::vector<Split> splits = touching_corners(edges); !splits.empty())
        loops_ = divided(edges, splits, loops_.size());
    loops_ = untangled(without_opposites(edges_of(loops_)));
}

}  // namespace csg::reference
