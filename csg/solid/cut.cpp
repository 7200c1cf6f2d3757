// projection(cut = true): the cut of solids by the plane z = 0.
#include <algorithm>
#include <cmath>
#include <map>

#include "csg/solid/node_geometry.h"

namespace csg::solid {
namespace {

using PointPair = std::pair<std::uint32_t, std::uint32_t>;

/// Where the mesh meets the plane, a hair above it: corners on the plane count as below. Triangles that cross give
/// segments; the one behind an edge goes on where the one before it ends, so that the loops wind around what the mesh
/// winds around there.
std::vector<Loop> cut_mesh(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& triangles) {
    const auto is_up = [&](std::uint32_t i) { return points[i].z > 0; };
    std::multimap<PointPair, PointPair>
        segments;  // From the edge where the surface goes down to the one where it goes up.
    for (const glm::uvec3& t : triangles) {
        PointPair down{0, 0}, up{0, 0};
        bool crosses = false;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (is_up(a) == is_up(b)) {
                continue;
            }
            crosses = true;
            (is_up(a) ? down : up) = std::minmax(a, b);
        }
        if (crosses) {
            segments.emplace(down, up);
        }
    }
    const auto point = [&](const PointPair& edge) {
        const glm::dvec3 &a = points[edge.first], &b = points[edge.second];
        if (a.z == b.z || a.z == 0) {
            return glm::dvec2(a);
        }
        if (b.z == 0) {
            return glm::dvec2(b);
        }
        return glm::dvec2(a) + (glm::dvec2(b) - glm::dvec2(a)) * (a.z / (a.z - b.z));
    };
    std::vector<Loop> loops;
    while (!segments.empty()) {
        Loop& loop = loops.emplace_back();
        auto segment = segments.begin();
        while (segment != segments.end()) {
            const glm::dvec2 p = point(segment->first);
            if (loop.empty() || loop.back() != p) {
                loop.push_back(p);
            }
            const PointPair end = segment->second;
            segments.erase(segment);
            segment = segments.find(end);
        }
    }
    return loops;
}

/// Points that rounding has moved off the plane, by no more than the grid of outlines, are on it.
std::vector<glm::dvec3> placed_points(const Piece& piece) {
    std::vector<glm::dvec3> points;
    double reach = 0;
    for (const glm::dvec3& p : piece.solid->points) {
        const glm::dvec3& placed = points.emplace_back(piece.placed * glm::dvec4(p, 1.0));
        reach = std::max({reach, std::abs(placed.x), std::abs(placed.y), std::abs(placed.z)});
    }
    for (glm::dvec3& p : points) {
        if (std::abs(p.z) <= reach * 0x1p-40) {
            p.z = 0;
        }
    }
    return points;
}

std::shared_ptr<const Outline> cut_piece(const Piece& piece) {
    if (piece.boolean) {
        check_depth(*piece.boolean);
        std::vector<std::shared_ptr<const Outline>> operands;
        for (const auto& operand : piece.boolean->operands) {
            std::vector<Piece> moved = operand;
            for (Piece& p : moved) {
                p.placed = piece.placed * p.placed;
            }
            operands.push_back(std::make_shared<Outline>(cut(moved)));
        }
        return std::make_shared<Outline>(combine(piece.boolean->kind, operands));
    }
    const std::vector<glm::dvec3> points = placed_points(piece);
    // Inside is a winding number where the mesh has one (solid.h).
    return std::make_shared<Outline>(
        clean(cut_mesh(points, piece.solid->triangles), piece.solid->closed ? FillRule::NonZero : FillRule::EvenOdd));
}

}  // namespace

Outline cut(std::span<const Piece> pieces) {
    std::vector<std::shared_ptr<const Outline>> outlines;
    for (const Piece& piece : pieces) {
        outlines.push_back(cut_piece(piece));
    }
    return combine(BooleanKind::Union, outlines);
}

}  // namespace csg::solid
