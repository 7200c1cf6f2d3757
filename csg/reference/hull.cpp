#include "csg/reference/hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/stop.h"
#include "csg/reference/disjoint_sets.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_3>;

/// An edge of a triangle, from a corner to the next.
struct Edge {
    std::uint32_t from, to, triangle, apex;
};

/// The faces of a convex hull, each triangulated from its smallest corner. What CGAL gives follows the addresses of its
/// vertices wherever more than three points lie in one face.
class Faces {
  public:
    Faces(const Points& points, std::span<const glm::uvec3> triangles) : points_(points), sets_(triangles.size()) {
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                edges_.push_back({triangles[t][k], triangles[t][(k + 1) % 3], t, triangles[t][(k + 2) % 3]});
            }
        }
        std::sort(edges_.begin(), edges_.end(),
                  [](const Edge& a, const Edge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
    }

    std::vector<glm::uvec3> triangulate() {
        for (const Edge& e : edges_) {
            const Edge& other = opposite(e);
            if (CGAL::coplanar(points_[e.from], points_[e.to], points_[e.apex], points_[other.apex])) {
                sets_.unite(e.triangle, other.triangle);
            }
        }
        // The borders of each face.
        std::vector<Edge> borders;
        for (const Edge& e : edges_) {
            if (const std::uint32_t face = sets_.find(e.triangle); face != sets_.find(opposite(e).triangle)) {
                borders.push_back({e.from, e.to, face, e.apex});
            }
        }
        std::stable_sort(borders.begin(), borders.end(),
                         [](const Edge& a, const Edge& b) { return a.triangle < b.triangle; });
        std::vector<glm::uvec3> result;
        for (std::size_t i = 0, j; i < borders.size(); i = j) {
            for (j = i + 1; j < borders.size() && borders[j].triangle == borders[i].triangle; ++j) {
            }
            add_fan(std::span(borders).subspan(i, j - i), result);
        }
        std::sort(result.begin(), result.end(), [](const glm::uvec3& a, const glm::uvec3& b) {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        });
        return result;
    }

  private:
    [[nodiscard]] const Edge& opposite(const Edge& e) const {
        const auto at = std::lower_bound(edges_.begin(), edges_.end(), std::pair(e.to, e.from),
                                         [](const Edge& a, const auto& b) { return std::pair(a.from, a.to) < b; });
        return *at;
    }

    /// `border`: the edges of a face, sorted by where they start.
    void add_fan(std::span<const Edge> border, std::vector<glm::uvec3>& to) const {
        std::vector<std::uint32_t> loop;
        for (const Edge* e = &border[0]; loop.size() < border.size();) {
            loop.push_back(e->from);
            e = &*std::lower_bound(border.begin(), border.end(), e->to,
                                   [](const Edge& a, std::uint32_t from) { return a.from < from; });
        }
        // What lies on an edge of the hull is no corner, on neither side of it.
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::uint32_t before = loop[(i + loop.size() - 1) % loop.size()], after = loop[(i + 1) % loop.size()];
            if (!CGAL::collinear(points_[before], points_[loop[i]], points_[after])) {
                corners.push_back(loop[i]);
            }
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        for (std::size_t i = 2; i < corners.size(); ++i) {
            to.emplace_back(corners[0], corners[i - 1], corners[i]);
        }
    }

    const Points& points_;
    std::vector<Edge> edges_;
    DisjointSets sets_;
};

/// The points that are corners, in their order.
Mesh mesh_of(const Points& points, std::vector<glm::uvec3> triangles) {
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> number(points.size(), kNone);
    for (const glm::uvec3& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            number[t[k]] = 0;
        }
    }
    Mesh mesh;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (number[i] == kNone) {
            continue;
        }
        number[i] = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.emplace_back(points[i].x(), points[i].y(), points[i].z());
    }
    for (glm::uvec3& t : triangles) {
        t = {number[t.x], number[t.y], number[t.z]};
    }
    mesh.triangles = std::move(triangles);
    mesh.sources.assign(mesh.triangles.size(), 0);
    return mesh;
}

}  // namespace

Mesh hull(std::span<const glm::dvec3> points, const std::stop_token& stop) {
    Points sorted;
    sorted.reserve(points.size());
    // Sorted, so that the order of the points does not matter to the result.
    for (const glm::dvec3& p : points) {
        sorted.emplace_back(p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    const auto flat = [&] {
        if (sorted.size() < 4) {
            return true;
        }
        // The first points that span a line, then a plane.
        const auto line = std::find_if(sorted.begin() + 2, sorted.end(),
                                       [&](const auto& p) { return !CGAL::collinear(sorted[0], sorted[1], p); });
        return line == sorted.end() || std::all_of(line, sorted.end(), [&](const auto& p) {
                   return CGAL::coplanar(sorted[0], sorted[1], *line, p);
               });
    };
    if (flat()) {
        return {};
    }
    base::end_if_asked(stop);
    CGAL::Surface_mesh<Kernel::Point_3> surface;
    try {
        CGAL::convex_hull_3(sorted.begin(), sorted.end(), surface);
    } catch (const std::logic_error&) {  // CGAL's
        throw std::runtime_error("no convex hull was found");
    }
    std::vector<std::uint32_t> place;  // by vertex: its place among the sorted points
    for (const auto v : surface.vertices()) {
        place.push_back(static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), surface.point(v)) -
                                                   sorted.begin()));
    }
    std::vector<glm::uvec3> triangles;
    for (const auto f : surface.faces()) {
        glm::uvec3 t;
        int k = 0;
        for (const auto v : surface.vertices_around_face(surface.halfedge(f))) {
            t[k++ % 3] = place[v.idx()];
        }
        triangles.push_back(t);
    }
    return mesh_of(sorted, Faces(sorted, triangles).triangulate());
}

bool convex(const Mesh& mesh) {
    const auto at = [&](std::uint32_t i) {
        return Kernel::Point_3(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    };
    // Locally convex at every edge, and in one piece: then convex.
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            edges.emplace_back(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
        }
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [a, b, c] : edges) {
        const auto other = std::lower_bound(edges.begin(), edges.end(), std::tuple(b, a, 0u));
        if (other == edges.end() || std::get<0>(*other) != b || std::get<1>(*other) != a) {
            return false;
        }
        if (CGAL::orientation(at(a), at(b), at(c), at(std::get<2>(*other))) == CGAL::POSITIVE) {
            return false;
        }
    }
    const MeshFacts f = facts(mesh);
    return f.components == 1 && f.genus == 0 && f.volume > 0;
}

}  // namespace csg::reference
