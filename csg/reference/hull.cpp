#include "csg/reference/hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <tuple>

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

}  // namespace

Mesh hull(std::span<const glm::dvec3> points) {
    std::vector<Kernel::Point_3> sorted;
    sorted.reserve(points.size());
    // Sorted, so that the order of the points does not matter to the result.
    for (const glm::dvec3& p : points)
        sorted.emplace_back(p.x + 0.0, p.y + 0.0, p.z + 0.0);
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    const auto flat = [&] {
        if (sorted.size() < 4)
            return true;
        // The first points that span a line, then a plane.
        const auto line = std::find_if(sorted.begin() + 2, sorted.end(),
                                       [&](const auto& p) { return !CGAL::collinear(sorted[0], sorted[1], p); });
        return line == sorted.end() || std::all_of(line, sorted.end(), [&](const auto& p) {
                   return CGAL::coplanar(sorted[0], sorted[1], *line, p);
               });
    };
    if (flat())
        return {};
    CGAL::Surface_mesh<Kernel::Point_3> surface;
    CGAL::convex_hull_3(sorted.begin(), sorted.end(), surface);
    Mesh mesh;
    for (const auto v : surface.vertices()) {
        const Kernel::Point_3& p = surface.point(v);
        mesh.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto f : surface.faces()) {
        glm::uvec3 t;
        int k = 0;
        for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
            t[k++ % 3] = static_cast<std::uint32_t>(v.idx());
        mesh.triangles.push_back(t);
    }
    mesh.sources.assign(mesh.triangles.size(), 0);
    return mesh;
}

bool convex(const Mesh& mesh) {
    const auto at = [&](std::uint32_t i) {
        return Kernel::Point_3(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    };
    // Locally convex at every edge, and in one piece: then convex.
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k)
            edges.emplace_back(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [a, b, c] : edges) {
        const auto other = std::lower_bound(edges.begin(), edges.end(), std::tuple(b, a, 0u));
        if (other == edges.end() || std::get<0>(*other) != b || std::get<1>(*other) != a)
            return false;
        if (CGAL::orientation(at(a), at(b), at(c), at(std::get<2>(*other))) == CGAL::POSITIVE)
            return false;
    }
    const MeshFacts f = facts(mesh);
    return f.components == 1 && f.genus == 0 && f.volume > 0;
}

}  // namespace csg::reference
