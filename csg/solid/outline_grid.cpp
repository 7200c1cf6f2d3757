#include "csg/solid/outline_grid.h"

#include <cmath>

#include "csg/solid/indexed_outline.h"
#include "csg/tree/finite.h"
#include "csg/tree/hash.h"

namespace csg::solid {
namespace {

constexpr int kBits = 40;

}  // namespace

std::size_t OutlineGrid::Hash::operator()(const GridPoint& p) const {
    return mix(mix(std::uint64_t{0}, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
}

void OutlineGrid::measure(std::span<const Loop> loops) {
    for (const Loop& loop : loops) {
        if (!std::all_of(loop.begin(), loop.end(), is_finite<2>)) {
            continue;
        }
        for (const glm::dvec2& p : loop) {
            largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y)});
        }
    }
}

void OutlineGrid::measure(double length) {
    if (std::isfinite(length)) {
        largest_ = std::max(largest_, std::abs(length));
    }
}

double OutlineGrid::scale() {
    if (scale_ == 0) {
        // Above 2^-984 or so, the scale is a number.
        constexpr double kLeast = 0x1p-960;
        scale_ = largest_ > 0 ? std::ldexp(1.0, kBits - 1 - std::ilogb(std::max(largest_, kLeast))) : 1.0;
    }
    return scale_;
}

GridLoop OutlineGrid::loop(const Loop& loop) {
    GridLoop result;
    if (!std::all_of(loop.begin(), loop.end(), is_finite<2>)) {
        return result;
    }
    result.reserve(loop.size());
    const double factor = scale();
    for (const glm::dvec2& p : loop) {
        result.push_back({std::llround(p.x * factor), std::llround(p.y * factor)});
        origin_.emplace(result.back(), p);
    }
    return result;
}

void OutlineGrid::add(std::span<const Loop> loops, std::vector<GridEdge>& edges, bool other) {
    for (const Loop& given : loops) {
        const GridLoop points = loop(given);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const GridPoint &p = points[i], &q = points[i + 1 < points.size() ? i + 1 : 0];
            if (p != q) {
                edges.push_back(directed_edge(p, q, other));
            }
        }
    }
}

glm::dvec2 OutlineGrid::point(const GridPoint& p) {
    const auto known = origin_.find(p);
    return known != origin_.end() ? known->second
                                  : glm::dvec2(static_cast<double>(p.x) / scale(), static_cast<double>(p.y) / scale());
}

Outline OutlineGrid::read(const std::vector<GridLoop>& loops) {
    Outline outline;
    for (const GridLoop& points : loops) {
        Loop& loop = outline.loops.emplace_back();
        for (const GridPoint& p : points) {
            loop.push_back(point(p));
        }
    }
    if (is_region(outline)) {
        return outline;
    }
    for (std::size_t i = 0; i < loops.size(); ++i) {
        for (std::size_t k = 0; k < loops[i].size(); ++k) {
            outline.loops[i][k] =
                glm::dvec2(static_cast<double>(loops[i][k].x) / scale(), static_cast<double>(loops[i][k].y) / scale());
        }
    }
    return outline;
}

}  // namespace csg::solid
