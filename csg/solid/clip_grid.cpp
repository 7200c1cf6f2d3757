#include "csg/solid/clip_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "csg/solid/orientation.h"
#include "csg/tree/finite.h"
#include "csg/tree/hash.h"

namespace csg::solid {
namespace {

constexpr int kBits = 40;

ClipperLib::Paths execute(ClipperLib::Clipper& clipper, ClipperLib::ClipType type, ClipperLib::PolyFillType rule) {
    ClipperLib::Paths result;
    try {
        clipper.Execute(type, result, rule, rule);
    } catch (const ClipperLib::clipperException& error) {
        throw OutlineError(error.what());
    }
    orient(result);
    return result;
}

void add(ClipperLib::Clipper& clipper, const ClipperLib::Paths& paths, ClipperLib::PolyType type) {
    try {
        clipper.AddPaths(paths, type, true);
    } catch (const ClipperLib::clipperException& error) {
        throw OutlineError(error.what());
    }
}

using Events = std::vector<std::pair<ClipperLib::cInt, int>>;

void add_events(const ClipperLib::Paths& paths, Events& events) {
    for (const ClipperLib::Path& path : paths) {
        for (std::size_t i = 0; i < path.size(); ++i) {
            const auto [low, high] = std::minmax(path[i].Y, path[(i + 1) % path.size()].Y);
            if (low < high) {
                events.emplace_back(low, 1);
                events.emplace_back(high, -1);
            }
        }
    }
}

/// Clipper's sweep compares each edge with those that it meets at one height. Where that would take hours, as with ten
/// thousand circles all over each other, there is an error instead.
void check_cost(const ClipperLib::Paths& a, const ClipperLib::Paths& b) {
    constexpr double kMost = 2e9;
    Events events;
    add_events(a, events);
    add_events(b, events);
    const double edges = static_cast<double>(events.size()) / 2;
    if (edges * edges < kMost)
        return;
    std::sort(events.begin(), events.end());
    int abreast = 0, most = 0;
    for (const auto& [height, change] : events) {
        abreast += change;
        most = std::max(most, abreast);
    }
    if (edges * most > kMost)
        throw OutlineError(
            fmt::format("outlines with {} edges, {} of them abreast, are more than can be united", edges, most));
}

}  // namespace

std::size_t ClipGrid::Hash::operator()(const std::pair<ClipperLib::cInt, ClipperLib::cInt>& p) const {
    return mix(mix(std::uint64_t{0}, static_cast<std::uint64_t>(p.first)), static_cast<std::uint64_t>(p.second));
}

void ClipGrid::measure(std::span<const Loop> loops) {
    for (const Loop& loop : loops) {
        if (!std::all_of(loop.begin(), loop.end(), is_finite<2>))
            continue;
        for (const glm::dvec2& p : loop)
            largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y)});
    }
}

void ClipGrid::measure(double length) {
    if (std::isfinite(length))
        largest_ = std::max(largest_, std::abs(length));
}

double ClipGrid::scale() {
    if (scale_ == 0)
        scale_ = largest_ > 0 ? std::ldexp(1.0, kBits - 1 - std::ilogb(largest_)) : 1.0;
    return scale_;
}

ClipperLib::Path ClipGrid::path(const Loop& loop) {
    ClipperLib::Path path;
    if (!std::all_of(loop.begin(), loop.end(), is_finite<2>))
        return path;
    path.reserve(loop.size());
    const double factor = scale();
    for (const glm::dvec2& p : loop) {
        path.emplace_back(std::llround(p.x * factor), std::llround(p.y * factor));
        origin_.emplace(std::pair(path.back().X, path.back().Y), p);
    }
    return path;
}

ClipperLib::Paths ClipGrid::paths(std::span<const Loop> loops) {
    ClipperLib::Paths result;
    for (const Loop& loop : loops) {
        if (ClipperLib::Path one = path(loop); one.size() > 2)
            result.push_back(std::move(one));
    }
    return result;
}

Outline ClipGrid::read(const ClipperLib::Paths& paths) {
    Outline outline;
    for (const ClipperLib::Path& path : paths) {
        if (path.size() < 3)
            continue;
        Loop& loop = outline.loops.emplace_back();
        for (const ClipperLib::IntPoint& p : path) {
            const auto known = origin_.find({p.X, p.Y});
            loop.push_back(known != origin_.end()
                               ? known->second
                               : glm::dvec2(static_cast<double>(p.X) / scale(), static_cast<double>(p.Y) / scale()));
        }
    }
    return outline;
}

ClipperLib::Paths ClipGrid::unite(const ClipperLib::Paths& paths, ClipperLib::PolyFillType rule) {
    check_cost(paths, {});
    ClipperLib::Clipper clipper;
    add(clipper, paths, ClipperLib::ptSubject);
    return execute(clipper, ClipperLib::ctUnion, rule);
}

ClipperLib::Paths ClipGrid::combine(ClipperLib::ClipType type, const ClipperLib::Paths& a, const ClipperLib::Paths& b) {
    check_cost(a, b);
    ClipperLib::Clipper clipper;
    add(clipper, a, ClipperLib::ptSubject);
    add(clipper, b, ClipperLib::ptClip);
    return execute(clipper, type, ClipperLib::pftNonZero);
}

}  // namespace csg::solid
