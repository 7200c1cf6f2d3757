// Cells from the edges of a plane, in the arithmetic of a CGAL kernel. For this library's own files.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

#include "csg/reference/plane_cells.h"

namespace csg::reference {

/// Edges between points lo < hi, each with what covers its left minus what covers its right, seen against the plane's
/// normal. No two cross, and no point lies on an edge.
class PlaneEdges {
  public:
    explicit PlaneEdges(const InsideRule& rule) : rule_(rule) {}

    static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    }
    void add(std::uint32_t a, std::uint32_t b) { edges_.try_emplace(key(a, b)); }
    /// A face of the leaf has the directed edge a → b as its border `count` times.
    void add(std::uint32_t a, std::uint32_t b, LeafId leaf, std::int32_t count) {
        Covers& change = edges_[key(a, b)];
        change = rule_.sum(change, {{leaf, count}}, a < b ? 1 : -1);
    }
    [[nodiscard]] const Covers* find(std::uint32_t a, std::uint32_t b) const {
        const auto found = edges_.find(key(a, b));
        return found == edges_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] std::vector<std::uint64_t> sorted() const {
        std::vector<std::uint64_t> keys;
        keys.reserve(edges_.size());
        for (const auto& [edge, change] : edges_) {
            keys.push_back(edge);
        }
        std::sort(keys.begin(), keys.end());
        return keys;
    }
    [[nodiscard]] const InsideRule& rule() const { return rule_; }

  private:
    const InsideRule& rule_;
    std::unordered_map<std::uint64_t, Covers> edges_;
};

template <typename Kernel>
class CellMaker {
  public:
    explicit CellMaker(const PlaneEdges& edges) : edges_(edges) {}

    /// `at(point)`: the place of a point in the plane, a Kernel::Point_2.
    template <typename At>
    PlaneCells make(At&& at) {
        if (triangulate(at)) {
            flood();
            collect_sides();
        }
        return std::move(result_);
    }

  private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    struct CellOf {
        std::uint32_t cell = kNone;
    };
    using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;  // the point's id
    using Faces =
        CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<CellOf, Kernel>>;
    using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
    using Triangulation =
        CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                   CGAL::No_constraint_intersection_requiring_constructions_tag>;
    using Face = typename Triangulation::Face_handle;

    template <typename At>
    bool triangulate(At& at) {
        const std::vector<std::uint64_t> ordered = edges_.sorted();
        std::vector<std::uint32_t> ids;
        for (const std::uint64_t edge : ordered) {
            ids.push_back(static_cast<std::uint32_t>(edge >> 32));
            ids.push_back(static_cast<std::uint32_t>(edge));
        }
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        std::vector<std::pair<typename Kernel::Point_2, std::uint32_t>> points;
        points.reserve(ids.size());
        for (const std::uint32_t id : ids) {
            points.emplace_back(at(id), id);
        }
        triangulation_.insert(points.begin(), points.end());
        if (triangulation_.number_of_vertices() != points.size()) {
            throw Undecided("two points of a plane coincide in its picture");
        }
        if (triangulation_.dimension() < 2) {
            return false;
        }
        std::unordered_map<std::uint32_t, typename Triangulation::Vertex_handle> handles;
        for (auto v = triangulation_.finite_vertices_begin(); v != triangulation_.finite_vertices_end(); ++v) {
            handles[v->info()] = v;
        }
        try {
            for (const std::uint64_t edge : ordered) {
                triangulation_.insert_constraint(handles.at(static_cast<std::uint32_t>(edge >> 32)),
                                                 handles.at(static_cast<std::uint32_t>(edge)));
            }
        } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
            throw Undecided("two segments of a plane cross within the tolerance");
        }
        return true;
    }

    struct Border {
        Face face;
        int edge;
    };

    /// Walks from the outside in: what covers a cell follows from what covers its neighbor.
    void flood() {
        std::vector<Covers> covers{{}};
        std::deque<std::vector<Border>> waiting{fill(triangulation_.infinite_face(), 0)};
        for (std::uint32_t cell = 0; cell < covers.size(); ++cell) {
            const std::vector<Border> borders = std::move(waiting.front());
            waiting.pop_front();
            for (const auto& [face, edge] : borders) {
                const Face next = face->neighbor(edge);
                Covers beyond = across(covers[cell], face, edge);
                if (next->info().cell == kNone) {
                    waiting.push_back(fill(next, static_cast<std::uint32_t>(covers.size())));
                    covers.push_back(std::move(beyond));
                } else if (covers[next->info().cell] != beyond) {
                    throw Undecided("the faces of a leaf do not close in a plane");
                }
            }
        }
        number_cells(covers);
    }

    /// What covers the other side of a border: the face is to the left of it.
    Covers across(const Covers& covers, Face face, int edge) const {
        const std::uint32_t a = face->vertex(Triangulation::ccw(edge))->info();
        const std::uint32_t b = face->vertex(Triangulation::cw(edge))->info();
        const Covers* change = edges_.find(a, b);
        if (change == nullptr) {
            throw Undecided("a segment passes through a point that it should not touch");
        }
        return edges_.rule().sum(covers, *change, a < b ? -1 : 1);
    }

    /// Marks the faces of a cell; gives its borders.
    std::vector<Border> fill(Face from, std::uint32_t cell) {
        std::vector<Border> borders;
        std::vector<Face> stack{from};
        from->info().cell = cell;
        while (!stack.empty()) {
            const Face face = stack.back();
            stack.pop_back();
            for (int i = 0; i < 3; ++i) {
                const Face next = face->neighbor(i);
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

    void number_cells(std::vector<Covers>& covers) {
        renumbered_.assign(covers.size(), kNone);
        for (auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f) {
            const std::uint32_t cell = f->info().cell;
            if (covers[cell].empty()) {
                continue;
            }
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
            if (cell == kNone) {
                continue;
            }
            for (int i = 0; i < 3; ++i) {
                if (!f->is_constrained(i)) {
                    continue;
                }
                const std::uint32_t a = f->vertex(Triangulation::ccw(i))->info();
                const std::uint32_t b = f->vertex(Triangulation::cw(i))->info();
                result_.sides.push_back({std::min(a, b), std::max(a, b), cell, a < b});
            }
        }
    }

    const PlaneEdges& edges_;
    Triangulation triangulation_;
    std::vector<std::uint32_t> renumbered_;
    PlaneCells result_;
};

}  // namespace csg::reference
