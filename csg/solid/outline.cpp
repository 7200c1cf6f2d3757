#include "csg/solid/outline.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/arrangement.h"
#include "csg/solid/indexed_outline.h"
#include "csg/solid/outline_grid.h"
#include "csg/solid/solid.h"
#include "csg/solid/widen.h"
#include "csg/tree/degrees.h"
#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

bool usable_length(double size) {
    return std::isfinite(size) && size > 0;
}

}  // namespace

double area2(const Loop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        sum += turn(loop[0], loop[i], loop[(i + 1) % loop.size()]);
    }
    return sum;
}

Box bounds_of(std::span<const Loop> loops) {
    Box box;
    for (const Loop& loop : loops) {
        for (const glm::dvec2& p : loop) {
            box = enclose(box, glm::dvec3(p, 0.0));
        }
    }
    return box;
}

std::size_t Outline::corners() const {
    std::size_t sum = 0;
    for (const Loop& loop : loops) {
        sum += loop.size();
    }
    return sum;
}

double Outline::area() const {
    double sum = 0;
    for (const Loop& loop : loops) {
        sum += area2(loop);
    }
    return sum / 2;
}

Outline clean(std::span<const Loop> loops, FillRule rule) {
    OutlineGrid grid;
    grid.measure(loops);
    std::vector<GridEdge> edges;
    grid.add(loops, edges);
    const bool even_odd = rule == FillRule::EvenOdd;
    return grid.read(boundary(arrange(std::move(edges)),
                              [&](int winding, int) { return even_odd ? winding % 2 != 0 : winding != 0; }));
}

Outline combine(BooleanKind kind, std::span<const std::shared_ptr<const Outline>> operands) {
    if (operands.empty()) {
        return {};
    }
    const bool unites = kind == BooleanKind::Union, subtracts = kind == BooleanKind::Difference;
    std::vector<const Outline*> some;
    for (const auto& operand : operands) {
        if (!operand->empty()) {
            some.push_back(operand.get());
        } else if (kind == BooleanKind::Intersection || (subtracts && operand == operands[0])) {
            return {};
        }
    }
    if (some.empty()) {
        return {};
    }
    if (some.size() == 1) {
        return *some[0];
    }
    OutlineGrid grid;
    for (const Outline* operand : some) {
        grid.measure(operand->loops);
    }
    std::vector<GridEdge> edges;
    for (const Outline* operand : some) {
        grid.add(operand->loops, edges, subtracts && operand != some[0]);
    }
    // Each operand winds once around what it holds.
    const int least = unites || subtracts ? 1 : static_cast<int>(some.size());
    return grid.read(boundary(arrange(std::move(edges)), [&](int in, int out) { return in >= least && out <= 0; }));
}

Outline offset(const Outline& outline, const Offset& how) {
    if (outline.empty() || !std::isfinite(how.distance)) {
        return {};
    }
    if (how.distance == 0) {
        return outline;
    }
    Widening widening;
    widening.distance = how.distance;
    widening.miter_limit = 1e6;  // OpenSCAD's: corners stay sharp.
    const double distance = std::abs(how.distance);
    const int segments = circle_segments(distance, how.fineness);
    widening.tolerance = distance * (1 - cos_degrees(180.0 / segments));
    widening.join = how.corner == Offset::Corner::Round   ? Join::Round
                    : how.corner == Offset::Corner::Miter ? Join::Miter
                                                          : Join::Square;
    return widen(outline.loops, widening);
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
    if (points.size() < 3) {
        return {};
    }
    // Andrew's monotone chain: the lower side, then the upper one.
    Loop chain;
    const auto extend = [&](const glm::dvec2& p, std::size_t least) {
        while (chain.size() > least && turn(chain[chain.size() - 2], chain.back(), p) <= 0) {
            chain.pop_back();
        }
        chain.push_back(p);
    };
    for (const glm::dvec2& p : points) {
        extend(p, 1);
    }
    const std::size_t lower = chain.size();
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) {
        extend(*p, lower);
    }
    chain.pop_back();
    if (chain.size() < 3) {
        return {};
    }
    return {{std::move(chain)}};
}

Outline transform(const Outline& outline, const glm::dmat4& m) {
    const double determinant = m[0][0] * m[1][1] - m[1][0] * m[0][1];
    Outline result;
    if (determinant == 0 || !std::isfinite(determinant)) {
        return result;
    }
    const double w = m[3][3] != 0 ? m[3][3] : 1;
    for (const Loop& loop : outline.loops) {
        Loop moved;
        moved.reserve(loop.size());
        for (const glm::dvec2& p : loop) {
            moved.emplace_back((m[0][0] * p.x + m[1][0] * p.y + m[3][0]) / w,
                               (m[0][1] * p.x + m[1][1] * p.y + m[3][1]) / w);
            if (!is_finite(moved.back())) {
                return {};
            }
        }
        if (determinant < 0) {
            std::reverse(moved.begin(), moved.end());
        }
        result.loops.push_back(std::move(moved));
    }
    // Rounding may move points over edges.
    return is_region(result) ? result : clean(result.loops, FillRule::NonZero);
}

Outline make_outline(const Square& square) {
    if (!usable_length(square.size.x) || !usable_length(square.size.y)) {
        return {};
    }
    const glm::dvec2 lo = square.center ? square.size * -0.5 : glm::dvec2(0.0);
    const glm::dvec2 hi = square.center ? square.size * 0.5 : square.size;
    return {{{lo, {hi.x, lo.y}, hi, {lo.x, hi.y}}}};
}

Outline make_outline(const Circle& circle) {
    if (!usable_length(circle.radius)) {
        return {};
    }
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
                if (index < polygon.points.size()) {
                    loop.push_back(polygon.points[index]);
                }
            }
        }
    }
    return clean(loops, FillRule::EvenOdd);
}

}  // namespace csg::solid
