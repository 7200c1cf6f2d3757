#include "csg/reference/plane_cells.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "csg/reference/cell_maker.h"
#include "csg/reference/plane_axes.h"

namespace csg::reference {

PlaneCells make_cells(const Content& content, const PlaneContent& plane, const InsideRule& rule) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    PlaneEdges edges(rule);
    const auto for_each_edge = [&](std::uint32_t segment, auto&& visit) {
        const std::vector<std::uint32_t> chain = content.segments.chain(segment, content.points);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            visit(chain[i], chain[i + 1]);
    };
    for (const std::uint32_t id : plane.segments)
        for_each_edge(id, [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b); });
    for (const PlaneContent::Border& border : plane.borders)
        for_each_edge(border.segment,
                      [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b, border.leaf, border.count); });
    const PlaneAxes axes(plane.plane.normal);
    return CellMaker<Kernel>(edges).make([&](std::uint32_t id) {
        const glm::dvec2 p = axes(content.points[id]);
        return Kernel::Point_2(p.x, p.y);
    });
}

}  // namespace csg::reference
