#include "csg/solid/indexed_outline.h"

#include <cmath>
#include <numeric>
#include <tuple>

#include "csg/solid/plane_sweep.h"

namespace csg::solid {

IndexedOutline index_corners(const Outline& outline) {
    std::vector<glm::dvec2> corners;
    for (const Loop& loop : outline.loops) {
        corners.insert(corners.end(), loop.begin(), loop.end());
    }
    std::vector<std::uint32_t> order(corners.size()), point(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(corners[a].x, corners[a].y, a) < std::tuple(corners[b].x, corners[b].y, b);
    });
    // The first corner of each place, then its number among these.
    for (std::size_t i = 0; i < order.size(); ++i) {
        point[order[i]] = i > 0 && corners[order[i]] == corners[order[i - 1]] ? point[order[i - 1]] : order[i];
    }
    IndexedOutline result;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        if (point[i] == i) {
            point[i] = static_cast<std::uint32_t>(result.points.size());
            result.points.push_back(corners[i]);
        } else {
            point[i] = point[point[i]];
        }
    }
    std::size_t first = 0;
    for (const Loop& loop : outline.loops) {
        const auto begin = point.begin() + static_cast<std::ptrdiff_t>(first);
        result.loops.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(loop.size()));
        first += loop.size();
    }
    return result;
}

std::vector<GridPoint> exact_points(std::span<const glm::dvec2> points) {
    constexpr int kBits = 58;
    double largest = 0;
    for (const glm::dvec2& p : points) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
    const int exponent = largest > 0 ? kBits - 1 - std::ilogb(largest) : 0;
    std::vector<GridPoint> result;
    result.reserve(points.size());
    for (const glm::dvec2& p : points) {
        result.push_back({std::llround(std::ldexp(p.x, exponent)), std::llround(std::ldexp(p.y, exponent))});
    }
    return result;
}

LoopEdges edges_of(std::span<const GridPoint> points, std::span<const std::vector<std::uint32_t>> loops) {
    struct Item {
        GridEdge edge;
        std::uint32_t from, to;
    };
    std::vector<Item> items;
    for (const auto& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::uint32_t p = loop[i], q = loop[i + 1 < loop.size() ? i + 1 : 0];
            if (points[p] == points[q]) {
                return {};
            }
            const bool ascends = points[p] < points[q];
            items.push_back({directed_edge(points[p], points[q]), ascends ? p : q, ascends ? q : p});
        }
    }
    const auto key = [](const Item& item) { return std::tie(item.edge.a, item.edge.b); };
    std::sort(items.begin(), items.end(), [&](const Item& a, const Item& b) { return key(a) < key(b); });
    LoopEdges result;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0 && key(items[i]) == key(items[i - 1])) {
            return {};
        }
        result.edges.push_back(items[i].edge);
        result.from.push_back(items[i].from);
        result.to.push_back(items[i].to);
    }
    return result;
}

bool is_region(const Outline& outline) {
    if (outline.empty()) {
        return true;
    }
    const IndexedOutline indexed = index_corners(outline);
    std::vector<std::uint32_t> seen;
    for (const auto& loop : indexed.loops) {
        seen = loop;
        std::sort(seen.begin(), seen.end());
        if (seen.size() < 3 || std::adjacent_find(seen.begin(), seen.end()) != seen.end()) {
            return false;
        }
    }
    const std::vector<GridPoint> points = exact_points(indexed.points);
    const LoopEdges all = edges_of(points, indexed.loops);
    const auto is_inside = [&](std::uint32_t below) { return below != kNoEdge && all.edges[below].weight > 0; };
    return !all.edges.empty() && sweep(all.edges, [&](const SweepVertex& vertex) {
        bool inside = is_inside(vertex.below);
        for (const std::uint32_t e : vertex.right) {
            if ((all.edges[e].weight > 0) == inside) {
                return false;
            }
            inside = !inside;
        }
        return vertex.above == kNoEdge ? !inside : inside == (all.edges[vertex.above].weight < 0);
    });
}

}  // namespace csg::solid
