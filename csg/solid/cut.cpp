// projection(): the cut of solids by the plane z = 0, and their shadow on it.
#include <algorithm>
#include <map>

#include "csg/solid/node_geometry.h"

namespace csg::solid {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

enum class Side { Above, Below };

/// Where the mesh meets the plane, a hair above or below it: corners on the plane count to the other side. Triangles
/// that cross give segments; the one behind an edge goes on where the one before it ends.
std::vector<Loop> cut_mesh(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& triangles, Side side) {
    const auto is_up = [&](std::uint32_t i) { return side == Side::Above ? points[i].z > 0 : points[i].z >= 0; };
    std::multimap<Edge, Edge> segments;  // From the edge where the surface goes down to the one where it goes up.
    for (const glm::uvec3& t : triangles) {
        Edge down{0, 0}, up{0, 0};
        bool crosses = false;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (is_up(a) == is_up(b))
                continue;
            crosses = true;
            (is_up(a) ? down : up) = std::minmax(a, b);
        }
        if (crosses)
            segments.emplace(down, up);
    }
    const auto point = [&](const Edge& edge) {
        const glm::dvec3 &a = points[edge.first], &b = points[edge.second];
        if (a.z == b.z || a.z == 0)
            return glm::dvec2(a);
        if (b.z == 0)
            return glm::dvec2(b);
        return glm::dvec2(a) + (glm::dvec2(b) - glm::dvec2(a)) * (a.z / (a.z - b.z));
    };
    std::vector<Loop> loops;
    while (!segments.empty()) {
        Loop& loop = loops.emplace_back();
        auto segment = segments.begin();
        while (segment != segments.end()) {
            const glm::dvec2 p = point(segment->first);
            if (loop.empty() || loop.back() != p)
                loop.push_back(p);
            const Edge end = segment->second;
            segments.erase(segment);
            segment = segments.find(end);
        }
    }
    return loops;
}

Outline cut_on(std::span<const Piece> pieces, Side side);

std::shared_ptr<const Outline> cut_piece(const Piece& piece, Side side) {
    if (piece.boolean) {
        check_depth(*piece.boolean);
        std::vector<std::shared_ptr<const Outline>> operands;
        for (const auto& operand : piece.boolean->operands) {
            std::vector<Piece> moved = operand;
            for (Piece& p : moved)
                p.placed = piece.placed * p.placed;
            operands.push_back(std::make_shared<Outline>(cut_on(moved, side)));
        }
        return std::make_shared<Outline>(combine(piece.boolean->kind, operands));
    }
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& p : piece.solid->points)
        points.emplace_back(piece.placed * glm::dvec4(p, 1.0));
    return std::make_shared<Outline>(clean(cut_mesh(points, piece.solid->triangles, side), FillRule::EvenOdd));
}

Outline cut_on(std::span<const Piece> pieces, Side side) {
    std::vector<std::shared_ptr<const Outline>> outlines;
    for (const Piece& piece : pieces)
        outlines.push_back(cut_piece(piece, side));
    return combine(BooleanKind::Union, outlines);
}

}  // namespace

Outline cut(std::span<const Piece> pieces) {
    const std::vector<std::shared_ptr<const Outline>> both{std::make_shared<Outline>(cut_on(pieces, Side::Above)),
                                                           std::make_shared<Outline>(cut_on(pieces, Side::Below))};
    return combine(BooleanKind::Union, both);
}

Outline shadow(std::span<const Mesh> meshes) {
    std::vector<std::shared_ptr<const Outline>> outlines;
    for (const Mesh& mesh : meshes) {
        std::vector<Loop> loops;
        for (const glm::uvec3& t : mesh.triangles) {
            Loop loop{glm::dvec2(mesh.points[t.x]), glm::dvec2(mesh.points[t.y]), glm::dvec2(mesh.points[t.z])};
            // Of a closed mesh the triangles that look up cover all.
            if (area2(loop) > 0)
                loops.push_back(std::move(loop));
        }
        outlines.push_back(std::make_shared<Outline>(clean(loops, FillRule::NonZero)));
    }
    return combine(BooleanKind::Union, outlines);
}

}  // namespace csg::solid
