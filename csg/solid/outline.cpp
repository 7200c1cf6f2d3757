#include "csg/solid/outline.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/clip_grid.h"
#include "csg/solid/solid.h"
#include "csg/tree/degrees.h"
#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

bool usable(double size) {
    return std::isfinite(size) && size > 0;
}

ClipperLib::ClipType clip_type(BooleanKind kind) {
    switch (kind) {
        case BooleanKind::Difference:
            return ClipperLib::ctDifference;
        case BooleanKind::Intersection:
            return ClipperLib::ctIntersection;
        case BooleanKind::Union:
            break;
    }
    return ClipperLib::ctUnion;
}

}  // namespace

double area2(const Loop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += turn(loop[0], loop[i], loop[(i + 1) % loop.size()]);
    return sum;
}

Box bounds_of(std::span<const Loop> loops) {
    Box box;
    for (const Loop& loop : loops) {
        for (const glm::dvec2& p : loop)
            box = enclose(box, glm::dvec3(p, 0.0));
    }
    return box;
}

std::size_t Outline::corners() const {
    std::size_t sum = 0;
    for (const Loop& loop : loops)
        sum += loop.size();
    return sum;
}

double Outline::area() const {
    double sum = 0;
    for (const Loop& loop : loops)
        sum += area2(loop);
    return sum / 2;
}

Outline clean(std::span<const Loop> loops, FillRule rule) {
    ClipGrid grid;
    grid.measure(loops);
    return grid.read(
        grid.unite(grid.paths(loops), rule == FillRule::EvenOdd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero));
}

Outline combine(BooleanKind kind, std::span<const std::shared_ptr<const Outline>> operands) {
    if (operands.empty())
        return {};
    if (operands.size() == 1)
        return *operands[0];
    ClipGrid grid;
    for (const auto& operand : operands)
        grid.measure(operand->loops);
    if (kind != BooleanKind::Intersection) {
        ClipperLib::Paths first = grid.paths(operands[0]->loops), rest;
        for (const auto& operand : operands.subspan(1)) {
            for (ClipperLib::Path& path : grid.paths(operand->loops))
                rest.push_back(std::move(path));
        }
        // Each operand alone winds once around what it holds, so that together nothing winds to zero.
        return grid.read(grid.combine(clip_type(kind), first, rest));
    }
    ClipperLib::Paths all = grid.paths(operands[0]->loops);
    for (const auto& operand : operands.subspan(1))
        all = grid.combine(ClipperLib::ctIntersection, all, grid.paths(operand->loops));
    return grid.read(all);
}

Outline offset(const Outline& outline, const Offset& how) {
    if (outline.empty() || !std::isfinite(how.distance))
        return {};
    if (how.distance == 0)
        return outline;
    constexpr double kMiterLimit = 1e6;  // OpenSCAD's: corners stay sharp.
    ClipGrid grid;
    grid.measure(outline.loops);
    grid.measure(how.distance);
    const double distance = std::abs(how.distance);
    const int segments = circle_segments(distance, how.fineness);
    const double tolerance = distance * (1 - cos_degrees(180.0 / segments));
    ClipperLib::ClipperOffset clipper(kMiterLimit, tolerance * grid.scale());
    const ClipperLib::JoinType join = how.corner == Offset::Corner::Round   ? ClipperLib::jtRound
                                      : how.corner == Offset::Corner::Miter ? ClipperLib::jtMiter
                                                                            : ClipperLib::jtSquare;
    clipper.AddPaths(grid.paths(outline.loops), join, ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    try {
        clipper.Execute(result, how.distance * grid.scale());
    } catch (const ClipperLib::clipperException& error) {
        throw OutlineError(error.what());
    }
    return grid.read(result);
}

Outline fill(const Outline& outline) {
    std::vector<Loop> outer;
    std::copy_if(outline.loops.begin(), outline.loops.end(), std::back_inserter(outer),
                 [](const Loop& loop) { return area2(loop) > 0; });
    return outer.size() < 2 ? Outline{outer} : clean(outer, FillRule::NonZero);
}

Outline hull(std::span<const glm::dvec2> given) {
    std::vector<glm::dvec2> points;
    std::copy_if(given.begin(), given.end(), std::back_inserter(points), is_finite<2>);
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return {};
    // Andrew's monotone chain: the lower side, then the upper one.
    Loop chain;
    const auto extend = [&](const glm::dvec2& p, std::size_t least) {
        while (chain.size() > least && turn(chain[chain.size() - 2], chain.back(), p) <= 0)
            chain.pop_back();
        chain.push_back(p);
    };
    for (const glm::dvec2& p : points)
        extend(p, 1);
    const std::size_t lower = chain.size();
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p)
        extend(*p, lower);
    chain.pop_back();
    if (chain.size() < 3)
        return {};
    return {{std::move(chain)}};
}

Outline transform(const Outline& outline, const glm::dmat4& m) {
    const double determinant = m[0][0] * m[1][1] - m[1][0] * m[0][1];
    Outline result;
    if (determinant == 0 || !std::isfinite(determinant))
        return result;
    const double w = m[3][3] != 0 ? m[3][3] : 1;
    for (const Loop& loop : outline.loops) {
        Loop moved;
        moved.reserve(loop.size());
        for (const glm::dvec2& p : loop) {
            moved.emplace_back((m[0][0] * p.x + m[1][0] * p.y + m[3][0]) / w,
                               (m[0][1] * p.x + m[1][1] * p.y + m[3][1]) / w);
            if (!is_finite(moved.back()))
                return {};
        }
        if (determinant < 0)
            std::reverse(moved.begin(), moved.end());
        result.loops.push_back(std::move(moved));
    }
    return result;
}

Outline make_outline(const Square& square) {
    if (!usable(square.size.x) || !usable(square.size.y))
        return {};
    const glm::dvec2 lo = square.center ? square.size * -0.5 : glm::dvec2(0.0);
    const glm::dvec2 hi = square.center ? square.size * 0.5 : square.size;
    return {{{lo, {hi.x, lo.y}, hi, {lo.x, hi.y}}}};
}

Outline make_outline(const Circle& circle) {
    if (!usable(circle.radius))
        return {};
    const int segments = circle_segments(circle.radius, circle.fineness);
    Loop loop;
    loop.reserve(static_cast<std::size_t>(segments));
    for (int i = 0; i < segments; ++i) {
        const double angle = 360.0 * i / segments;
        loop.emplace_back(circle.radius * cos_degrees(angle), circle.radius * sin_degrees(angle));
    }
    return {{std::move(loop)}};
}

Outline make_outline(const Polygon& polygon) {
    std::vector<Loop> loops;
    if (!polygon.has_paths) {
        loops.push_back(polygon.points);
    } else {
        for (const auto& path : polygon.paths) {
            Loop& loop = loops.emplace_back();
            for (const std::uint32_t index : path) {
                if (index < polygon.points.size())
                    loop.push_back(polygon.points[index]);
            }
        }
    }
    return clean(loops, FillRule::EvenOdd);
}

}  // namespace csg::solid
