#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/solid/extrude.h"
#include "csg/solid/outline_curves.h"
#include "csg/solid/triangulate_region.h"
#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

struct Sweep {
    double start, angle;
    std::uint32_t steps;
    bool closed;  ///< All around: the last ring is the first.

    [[nodiscard]] std::uint32_t rings() const { return closed ? steps : steps + 1; }
};

/// Indices of the corners by ring. Corners on the axis are one point for all rings.
std::vector<std::vector<std::uint32_t>> add_rings(Solid& solid, const std::vector<glm::dvec2>& corners,
                                                  const Sweep& sweep) {
    std::vector<std::vector<std::uint32_t>> rings(sweep.rings());
    for (std::uint32_t k = 0; k < sweep.rings(); ++k) {
        const double angle = sweep.start + sweep.angle * k / sweep.steps;
        const double c = cos_degrees(angle), s = sin_degrees(angle);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2& p = corners[i];
            if (k > 0 && p.x == 0) {
                rings[k].push_back(rings[0][i]);
                continue;
            }
            rings[k].push_back(static_cast<std::uint32_t>(solid.points.size()));
            solid.points.emplace_back(p.x * c, p.x * s, p.y);
        }
    }
    return rings;
}

/// Corners that rounding has moved off the axis, by no more than the grid of outlines, are on it.
void put_on_axis(std::vector<glm::dvec2>& corners) {
    double reach = 0;
    for (const glm::dvec2& p : corners) {
        reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
    }
    for (glm::dvec2& p : corners) {
        if (std::abs(p.x) <= reach * 0x1p-40) {
            p.x = 0;
        }
    }
}

}  // namespace

std::shared_ptr<Solid> rotate_extrude(const Outline& given, const RotateExtrude& how) {
    auto solid = std::make_shared<Solid>();
    // Loops that meet in a point share it.
    IndexedOutline outline = index_corners(given);
    std::vector<glm::dvec2>& corners = outline.points;
    if (corners.empty() || how.angle == 0 || !std::isfinite(how.angle) || !std::isfinite(how.start)) {
        return solid;
    }
    put_on_axis(corners);
    double lo = 0, hi = 0;
    for (const glm::dvec2& p : corners) {
        lo = std::min(lo, p.x);
        hi = std::max(hi, p.x);
    }
    if (lo < 0 && hi > 0) {
        solid->failures.push_back(fmt::format(
            "all points for rotate_extrude() must have the same X coordinate sign (range is {:.2f} -> {:.2f})", lo,
            hi));
        return solid;
    }
    const double angle = std::clamp(how.angle, -360.0, 360.0);
    const int segments = circle_segments(hi - lo, how.fineness);
    Sweep sweep{how.start, angle,
                static_cast<std::uint32_t>(std::max(1.0, std::ceil(segments * std::abs(angle) / 360))),
                std::abs(angle) == 360};
    if (sweep.steps > kMostTriangles / corners.size() / 2) {
        throw GeometryError(
            fmt::format("rotate_extrude() has too many fragments: {} of {} corners each", sweep.steps, corners.size()));
    }
    const auto rings = add_rings(*solid, corners, sweep);
    const bool flip = (angle < 0) != (lo < 0);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, FacetGroup group) {
        if (a != b && b != c && c != a) {
            solid->triangles.push_back(flip ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
            solid->groups.push_back(group);
        }
    };
    const OutlineCurves curves = curves_of(given);
    const double step = std::abs(angle) / sweep.steps;
    const bool has_corners = how.fineness.fn > 0 && step > kMostBend;
    const std::uint32_t rows = has_corners ? sweep.steps : 1;
    /// The walls that an edge sweeps turn by less than it does where it is not parallel to the axis.
    const auto wall_of = [&](FacetGroup edge, const glm::dvec2& way, std::uint32_t k) {
        FacetGroup wall(edge.surface() + (has_corners ? k * curves.count : 0), edge.stretch());
        const double upright = std::abs(way.y) / glm::length(way);
        wall.bends(std::max(static_cast<double>(edge.bend()), has_corners ? 0 : step * upright));
        return wall;
    };
    for (std::uint32_t k = 0; k < sweep.steps; ++k) {
        const auto &here = rings[k], &there = rings[(k + 1) % rings.size()];
        for (std::size_t l = 0; l < outline.loops.size(); ++l) {
            const std::vector<std::uint32_t>& loop = outline.loops[l];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const std::uint32_t p = loop[i], q = loop[(i + 1) % loop.size()];
                const FacetGroup group = wall_of(curves.edges[l][i], corners[q] - corners[p], k);
                add(here[p], there[p], there[q], group);
                add(here[p], there[q], here[q], group);
            }
        }
    }
    if (!sweep.closed) {
        for (const glm::uvec3& t : triangulate_region(outline)) {
            add(rings.front()[t.x], rings.front()[t.y], rings.front()[t.z], FacetGroup(rows * curves.count));
            add(rings.back()[t.x], rings.back()[t.z], rings.back()[t.y], FacetGroup(rows * curves.count + 1));
        }
    }
    finish(*solid);
    solid->simple = std::abs(angle) < 180 * sweep.steps;
    return solid;
}

}  // namespace csg::solid
