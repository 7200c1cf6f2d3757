#include "csg/reference/nef.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_decomposition_3.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "csg/reference/disjoint_sets.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

using Faces = std::vector<std::vector<std::size_t>>;

struct Shell {
    std::vector<Kernel::Point_3> points;
    Faces faces;
};

/// Faces that share points, directly or through others.
std::vector<Shell> shells_of(const std::vector<Kernel::Point_3>& points, const Faces& faces) {
    const auto id = [](std::size_t point) { return static_cast<std::uint32_t>(point); };
    DisjointSets sets(points.size());
    for (const auto& face : faces) {
        for (const std::size_t p : face)
            sets.unite(id(p), id(face[0]));
    }
    std::map<std::uint32_t, std::size_t> shell_of;
    std::map<std::size_t, std::size_t> index_of;
    std::vector<Shell> shells;
    for (const auto& face : faces) {
        const auto [at, added] = shell_of.try_emplace(sets.find(id(face[0])), shells.size());
        if (added)
            shells.emplace_back();
        Shell& shell = shells[at->second];
        auto& own = shell.faces.emplace_back();
        for (const std::size_t p : face) {
            const auto [index, first] = index_of.try_emplace(p, shell.points.size());
            if (first)
                shell.points.push_back(points[p]);
            own.push_back(index->second);
        }
    }
    return shells;
}

Nef to_nef(Shell shell) {
    auto& [points, faces] = shell;
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
    Polyhedron surface;
    if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(faces))
        throw std::runtime_error("an operand's faces do not form a surface");
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, surface);
    if (!CGAL::is_closed(surface))
        throw std::runtime_error("an operand's surface is not closed");
    Nef nef(surface);
    return nef.is_bounded() ? nef : nef.complement();
}

Nef to_nef(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& triangles) {
    PointIds ids;
    std::vector<Kernel::Point_3> soup_points;
    Faces faces;
    for (const glm::uvec3& t : triangles) {
        std::vector<std::size_t> face;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3& p = points[t[k]];
            const auto [id, added] = ids.add(p);
            if (added)
                soup_points.emplace_back(p.x, p.y, p.z);
            face.push_back(id);
        }
        if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0] &&
            !CGAL::collinear(soup_points[face[0]], soup_points[face[1]], soup_points[face[2]]))
            faces.push_back(std::move(face));
    }
    if (faces.empty())
        return {};
    // CGAL takes all that shells enclose as inside. So each shell is a polyhedron by itself, and a point is inside
    // where an odd number of them hold it: a shell in a shell is a cavity.
    Nef all;
    for (Shell& shell : shells_of(soup_points, faces)) {
        Nef one = to_nef(std::move(shell));
        all = all.is_empty() ? std::move(one) : all ^ one;
    }
    return all;
}

}  // namespace

std::vector<std::vector<glm::dvec3>> convex_decomposition(const Mesh& mesh) {
    Nef nef = to_nef(mesh.points, mesh.triangles);
    std::vector<std::vector<glm::dvec3>> pieces;
    if (nef.is_empty())
        return pieces;
    CGAL::convex_decomposition_3(nef);
    for (auto volume = ++nef.volumes_begin(); volume != nef.volumes_end(); ++volume) {  // the first is outside
        if (!volume->mark())
            continue;
        Polyhedron piece;
        nef.convert_inner_shell_to_polyhedron(volume->shells_begin(), piece);
        std::vector<glm::dvec3>& points = pieces.emplace_back();
        for (auto p = piece.points_begin(); p != piece.points_end(); ++p)
            points.emplace_back(CGAL::to_double(p->x()), CGAL::to_double(p->y()), CGAL::to_double(p->z()));
    }
    return pieces;
}

}  // namespace csg::reference
