#include "csg/reference/plane_cells.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "csg/reference/cell_maker.h"
#include "csg/reference/plane_axes.h"

namespace csg::reference {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

PlaneCells make_cells(const Content& content, const PlaneContent& plane, const InsideRule& rule) {
    PlaneEdges edges(rule);
    const auto for_each_edge = [&](std::uint32_t segment, auto&& visit) {
        const std::vector<std::uint32_t> chain = content.segments.chain(segment, content.points);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            visit(chain[i], chain[i + 1]);
        }
    };
    for (const std::uint32_t id : plane.segments) {
        for_each_edge(id, [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b); });
    }
    for (const PlaneContent::Border& border : plane.borders) {
        for_each_edge(border.segment,
                      [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b, border.leaf, border.count); });
    }
    const PlaneAxes axes(plane.plane.normal);
    return CellMaker<Kernel>(edges).make([&](std::uint32_t id) {
        const glm::dvec2 p = axes(content.points[id]);
        return Kernel::Point_2(p.x, p.y);
    });
}

std::vector<glm::uvec3> fill_area(std::span<const std::pair<std::uint32_t, std::uint32_t>> border,
                                  std::span<const glm::dvec3> points, const glm::dvec3& normal) {
    if (border.size() == 3 && border[0].second == border[1].first && border[1].second == border[2].first) {
        return {{border[0].first, border[1].first, border[2].first}};
    }
    const InsideRule rule;
    PlaneEdges edges(rule);
    for (const auto& [from, to] : border) {
        edges.add(from, to, 0, 1);
    }
    const PlaneAxes axes(normal);
    PlaneCells found = CellMaker<Kernel>(edges).make([&](std::uint32_t id) {
        const glm::dvec2 p = axes(points[id]);
        return Kernel::Point_2(p.x, p.y);
    });
    std::vector<glm::uvec3> triangles;
    for (const PlaneCells::Cell& cell : found.cells) {
        if (cell.covers != Covers{{0, 1}}) {
            throw Undecided("the outline of an area does not close");
        }
        triangles.insert(triangles.end(), cell.triangles.begin(), cell.triangles.end());
    }
    return triangles;
}

}  // namespace csg::reference
