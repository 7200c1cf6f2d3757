#include "csg/reference/plane_cells.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <deque>
#include <unordered_map>

#include "csg/reference/plane_axes.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::uint32_t kNone = ~std::uint32_t{0};
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;  // the point's id
struct CellOf {
    std::uint32_t cell = kNone;
};
using Faces =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<CellOf, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

using Leaves = std::vector<LeafId>;

std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// Those in just one of the two.
Leaves differ(const Leaves& a, const Leaves& b) {
    Leaves result;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

class CellMaker {
  public:
    CellMaker(const Content& content, const PlaneContent& plane, const glm::dvec3& normal)
        : content_(content), plane_(plane), axes_(normal) {}

    PlaneCells make() {
        collect_edges();
        if (triangulate()) {
            flood();
            collect_sides();
        }
        return std::move(result_);
    }

  private:
    /// The edges between neighbouring points of the segments, each with the leaves that begin or end there.
    void collect_edges() {
        for (const std::uint32_t id : plane_.segments)
            for_each_edge(id, [&](std::uint64_t edge) { edges_.try_emplace(edge); });
        for (const PlaneContent::Border& border : plane_.borders) {
            for_each_edge(border.segment, [&](std::uint64_t edge) {
                Leaves& leaves = edges_[edge];
                leaves = differ(leaves, {border.leaf});
            });
        }
    }

    template <typename Visit>
    void for_each_edge(std::uint32_t segment, Visit&& visit) const {
        const std::vector<std::uint32_t> chain = content_.segments.chain(segment, content_.points);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            visit(key(chain[i], chain[i + 1]));
    }

    bool triangulate() {
        std::vector<std::uint64_t> ordered;
        std::vector<std::uint32_t> ids;
        for (const auto& [edge, leaves] : edges_) {
            ordered.push_back(edge);
            ids.push_back(static_cast<std::uint32_t>(edge >> 32));
            ids.push_back(static_cast<std::uint32_t>(edge));
        }
        std::sort(ordered.begin(), ordered.end());
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
        for (const std::uint32_t id : ids) {
            const glm::dvec2 p = axes_(content_.points[id]);
            points.emplace_back(Kernel::Point_2(p.x, p.y), id);
        }
        triangulation_.insert(points.begin(), points.end());
        if (triangulation_.number_of_vertices() != points.size())
            throw Undecided("two points of a plane coincide in its picture");
        if (triangulation_.dimension() < 2)
            return false;
        std::unordered_map<std::uint32_t, Triangulation::Vertex_handle> handles;
        for (auto v = triangulation_.finite_vertices_begin(); v != triangulation_.finite_vertices_end(); ++v)
            handles[v->info()] = v;
        try {
            for (const std::uint64_t edge : ordered)
                triangulation_.insert_constraint(handles.at(static_cast<std::uint32_t>(edge >> 32)),
                                                 handles.at(static_cast<std::uint32_t>(edge)));
        } catch (const Triangulation::Intersection_of_constraints_exception&) {
            throw Undecided("two segments of a plane cross within the tolerance");
        }
        return true;
    }

    /// The leaves that change where the edge is crossed.
    const Leaves& change(Triangulation::Face_handle face, int edge) const {
        const std::uint32_t a = face->vertex(Triangulation::ccw(edge))->info();
        const std::uint32_t b = face->vertex(Triangulation::cw(edge))->info();
        const auto found = edges_.find(key(a, b));
        if (found == edges_.end())
            throw Undecided("a segment passes through a point that it should not touch");
        return found->second;
    }

    struct Border {
        Triangulation::Face_handle face;
        int edge;
    };

    /// Walks from the outside in: the leaves that cover a cell follow from those that cover its neighbour.
    void flood() {
        std::vector<Leaves> covers{{}};
        std::deque<std::vector<Border>> waiting{fill(triangulation_.infinite_face(), 0)};
        for (std::uint32_t cell = 0; cell < covers.size(); ++cell) {
            const std::vector<Border> borders = std::move(waiting.front());
            waiting.pop_front();
            for (const auto& [face, edge] : borders) {
                const Triangulation::Face_handle next = face->neighbor(edge);
                Leaves leaves = differ(covers[cell], change(face, edge));
                if (next->info().cell == kNone) {
                    waiting.push_back(fill(next, static_cast<std::uint32_t>(covers.size())));
                    covers.push_back(std::move(leaves));
                } else if (covers[next->info().cell] != leaves) {
                    throw Undecided("the faces of a leaf do not close in a plane");
                }
            }
        }
        number_cells(covers);
    }

    /// Marks the faces of a cell; gives its borders.
    std::vector<Border> fill(Triangulation::Face_handle from, std::uint32_t cell) {
        std::vector<Border> borders;
        std::vector<Triangulation::Face_handle> stack{from};
        from->info().cell = cell;
        while (!stack.empty()) {
            const Triangulation::Face_handle face = stack.back();
            stack.pop_back();
            for (int i = 0; i < 3; ++i) {
                const Triangulation::Face_handle next = face->neighbor(i);
                if (face->is_constrained(i)) {
                    borders.push_back({face, i});
                } else if (next->info().cell == kNone) {
                    next->info().cell = cell;
                    stack.push_back(next);
                }
            }
        }
        return borders;
    }

    void number_cells(std::vector<Leaves>& covers) {
        renumbered_.assign(covers.size(), kNone);
        for (auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f) {
            const std::uint32_t cell = f->info().cell;
            if (covers[cell].empty())
                continue;
            if (renumbered_[cell] == kNone) {
                renumbered_[cell] = static_cast<std::uint32_t>(result_.cells.size());
                result_.cells.push_back({covers[cell], {}});
            }
            result_.cells[renumbered_[cell]].triangles.emplace_back(f->vertex(0)->info(), f->vertex(1)->info(),
                                                                    f->vertex(2)->info());
        }
    }

    void collect_sides() {
        for (auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f) {
            const std::uint32_t cell = renumbered_[f->info().cell];
            if (cell == kNone)
                continue;
            for (int i = 0; i < 3; ++i) {
                if (!f->is_constrained(i))
                    continue;
                const std::uint32_t a = f->vertex(Triangulation::ccw(i))->info();
                const std::uint32_t b = f->vertex(Triangulation::cw(i))->info();
                result_.sides.push_back({std::min(a, b), std::max(a, b), cell, a < b});
            }
        }
    }

    const Content& content_;
    const PlaneContent& plane_;
    PlaneAxes axes_;
    std::unordered_map<std::uint64_t, Leaves> edges_;
    Triangulation triangulation_;
    std::vector<std::uint32_t> renumbered_;
    PlaneCells result_;
};

}  // namespace

PlaneCells make_cells(const Content& content, const PlaneContent& plane, const glm::dvec3& normal) {
    return CellMaker(content, plane, normal).make();
}

}  // namespace csg::reference
