#include "csg/solid/arrangement.h"

#include <fmt/format.h>

#include <set>
#include <span>
#include <tuple>

#include "csg/solid/outline.h"
#include "csg/solid/segment_grid.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostCrossings = std::size_t{1} << 21;
constexpr double kMostComparisons = 4e9;
constexpr std::size_t kFewEdges = 64;  // Compared without asking first who crosses at all.

/// 1 for edges of which some must be taken out so that the others do not conflict: a sweep that takes an edge out as
/// soon as it conflicts with a neighbor.
std::vector<char> crossers(std::span<const GridEdge> edges) {
    std::vector<char> out(edges.size(), 0);
    const auto below = [&](std::uint32_t e, std::uint32_t f) { return is_below(edges[e], edges[f]); };
    using Status = std::set<std::uint32_t, decltype(below)>;
    Status status(below);
    std::vector<Status::iterator> place(edges.size());
    std::vector<std::uint32_t> by_end(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        by_end[i] = i;
    }
    std::sort(by_end.begin(), by_end.end(),
              [&](std::uint32_t e, std::uint32_t f) { return std::tie(edges[e].b, e) < std::tie(edges[f].b, f); });
    // Neighbors from `low` on; the upper one is taken out while they conflict.
    const auto settle = [&](Status::iterator low) {
        while (low != status.end() && std::next(low) != status.end() && conflict(edges[*low], edges[*std::next(low)])) {
            out[*std::next(low)] = 1;
            status.erase(std::next(low));
        }
    };
    for (std::size_t begun = 0, ended = 0; ended < edges.size();) {
        if (begun == edges.size() || edges[by_end[ended]].b <= edges[begun].a) {
            const std::uint32_t e = by_end[ended++];
            if (out[e] != 0) {
                continue;
            }
            const auto next = status.erase(place[e]);
            if (next != status.begin()) {
                settle(std::prev(next));
            }
            continue;
        }
        const auto e = static_cast<std::uint32_t>(begun++);
        const auto [at, is_new] = status.insert(e);
        if (!is_new) {
            out[e] = 1;
            continue;
        }
        place[e] = at;
        settle(at);
        if (at != status.begin()) {
            settle(std::prev(at));
        }
    }
    return out;
}

Wide floor_divide(Wide a, Wide b) {
    if (b < 0) {
        a = -a;
        b = -b;
    }
    const Wide quotient = a / b;
    return quotient * b > a ? quotient - 1 : quotient;
}

/// Adds the grid point next to where the edges cross, if they do so away from their ends.
void cross_at(const GridEdge& e, const GridEdge& f, std::vector<GridPoint>& points) {
    if (e.b.x < f.a.x || f.b.x < e.a.x || std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) ||
        std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y)) {
        return;
    }
    const GridPoint along = e.b - e.a, other = f.b - f.a;
    if (sign(cross(other, e.a - f.a)) * sign(cross(other, e.b - f.a)) >= 0 ||
        sign(cross(along, f.a - e.a)) * sign(cross(along, f.b - e.a)) >= 0) {
        return;
    }
    const Wide part = cross(f.a - e.a, other), whole = cross(along, other);
    const auto rounded = [&](std::int64_t start, std::int64_t way) {
        return start + static_cast<std::int64_t>(floor_divide(2 * part * way + whole, 2 * whole));
    };
    points.push_back({rounded(e.a.x, along.x), rounded(e.a.y, along.y)});
}

/// Does the edge pass through the unit square around p, without its upper and right sides? Sides are told apart as if
/// the square were moved by less than anything to the left, and by even less down.
bool passes(const GridEdge& e, const GridPoint& p) {
    if (p.x < e.a.x || p.x > e.b.x || p.y < std::min(e.a.y, e.b.y) || p.y > std::max(e.a.y, e.b.y)) {
        return false;
    }
    const GridPoint along = e.b - e.a, twice{2 * (p.x - e.a.x), 2 * (p.y - e.a.y)};
    int sum = 0;
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(-1, 1), std::pair(1, -1), std::pair(1, 1)}) {
        int side = sign(cross(along, {twice.x + x, twice.y + y}));
        if (side == 0) {
            side = along.y != 0 ? sign(along.y) : -sign(along.x);
        }
        sum += side;
    }
    return sum != 4 && sum != -4;
}

void check(double comparisons, std::size_t edges) {
    if (comparisons > kMostComparisons) {
        throw OutlineError(
            fmt::format("outlines with {} edges, so many of them near each other, are more than can be "
                        "united",
                        edges));
    }
}

/// All points where edges end or cross, sorted.
std::vector<GridPoint> hot_points(std::span<const GridEdge> edges, const SegmentGrid& grid, std::span<const char> out) {
    double comparisons = 0;
    std::vector<std::uint32_t> crossing;
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        const auto here = grid.in(cell);
        comparisons +=
            static_cast<double>(here.size()) *
            static_cast<double>(std::count_if(here.begin(), here.end(), [&](auto e) { return out[e] != 0; }));
    }
    check(comparisons, edges.size());
    std::vector<GridPoint> points;
    for (const GridEdge& e : edges) {
        points.insert(points.end(), {e.a, e.b});
    }
    const std::size_t ends = points.size();
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        const auto here = grid.in(cell);
        for (const std::uint32_t e : here) {
            if (out[e] == 0) {
                continue;
            }
            for (const std::uint32_t f : here) {
                if (out[f] == 0 || e < f) {
                    cross_at(edges[e], edges[f], points);
                }
            }
        }
        if (points.size() > ends + 4 * kMostCrossings) {
            throw OutlineError("outlines that cross each other in more than 2097152 places");
        }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace

void merge(std::vector<GridEdge>& edges) {
    std::sort(edges.begin(), edges.end(),
              [](const GridEdge& e, const GridEdge& f) { return std::tie(e.a, e.b) < std::tie(f.a, f.b); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size();) {
        GridEdge sum = edges[i];
        for (++i; i < edges.size() && edges[i].a == sum.a && edges[i].b == sum.b; ++i) {
            sum.weight += edges[i].weight;
            sum.other += edges[i].other;
        }
        if (sum.weight != 0 || sum.other != 0) {
            edges[kept++] = sum;
        }
    }
    edges.resize(kept);
}

std::vector<GridEdge> arrange(std::vector<GridEdge> edges) {
    merge(edges);
    const std::vector<char> out = edges.size() <= kFewEdges ? std::vector<char>(edges.size(), 1) : crossers(edges);
    const SegmentGrid grid(edges);
    const std::vector<GridPoint> points = hot_points(edges, grid, out);
    double comparisons = 0;
    for (const GridPoint& p : points) {
        grid.around(p, [&](std::size_t cell) { comparisons += static_cast<double>(grid.in(cell).size()); });
    }
    check(comparisons, edges.size());

    struct Visit {
        std::uint32_t edge;
        Wide way;
        GridPoint at;
    };
    std::vector<Visit> visits;
    for (const GridPoint& p : points) {
        grid.around(p, [&](std::size_t cell) {
            for (const std::uint32_t e : grid.in(cell)) {
                if (p != edges[e].a && p != edges[e].b && passes(edges[e], p)) {
                    visits.push_back({e, dot(p - edges[e].a, edges[e].b - edges[e].a), p});
                }
            }
        });
    }
    if (visits.empty()) {
        return edges;
    }
    std::sort(visits.begin(), visits.end(), [](const Visit& v, const Visit& w) {
        return std::tie(v.edge, v.way, v.at) < std::tie(w.edge, w.way, w.at);
    });
    std::vector<GridEdge> result;
    auto visit = visits.begin();
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        const GridEdge& edge = edges[i];
        GridPoint here = edge.a;
        const auto go_to = [&](const GridPoint& there) {
            if (there == here) {
                return;
            }
            const int way = here < there ? 1 : -1;  // A nearly upright edge may lean the other way now.
            result.push_back({std::min(here, there), std::max(here, there), way * edge.weight, way * edge.other});
            here = there;
        };
        for (; visit != visits.end() && visit->edge == i; ++visit) {
            go_to(visit->at);
        }
        go_to(edge.b);
    }
    merge(result);
    return result;
}

}  // namespace csg::solid
