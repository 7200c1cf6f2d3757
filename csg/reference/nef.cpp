#include "csg/reference/nef.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/convex_decomposition_3.h>

#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "csg/reference/disjoint_sets.h"
#include "csg/reference/expression_value.h"
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

Mesh to_mesh(const Nef& nef) {
    if (nef.is_empty())
        return {};
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    CGAL::convert_nef_polyhedron_to_polygon_soup(nef, points, faces, true);
    Mesh mesh;
    for (const Kernel::Point_3& p : points)
        mesh.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    for (const auto& face : faces) {
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            mesh.triangles.emplace_back(face[0], face[i], face[i + 1]);
    }
    mesh.sources.assign(mesh.triangles.size(), 0);
    return mesh;
}

/// For each triangle the leaf with a face whose plane is nearest to it.
void find_sources(Mesh& mesh, const solid::Geometry& geometry) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3 centre = (mesh.points[t.x] + mesh.points[t.y] + mesh.points[t.z]) / 3.0;
        double best = std::numeric_limits<double>::infinity();
        for (LeafId leaf = 0; leaf < geometry.leaves.size(); ++leaf) {
            const solid::PlacedLeaf& placed = geometry.leaves[leaf];
            const double margin = 1e-6 * placed.box.diagonal();
            if (glm::any(glm::lessThan(centre, placed.box.lo - margin)) ||
                glm::any(glm::greaterThan(centre, placed.box.hi + margin)))
                continue;
            for (const solid::PlaneRef& ref : placed.planes) {
                const solid::Plane& plane = geometry.planes.planes()[ref.index];
                double off = 0;
                for (int k = 0; k < 3; ++k)
                    off = std::max(off, std::abs(glm::dot(plane.normal, mesh.points[t[k]]) - plane.offset));
                if (off < best) {
                    best = off;
                    mesh.sources[i] = leaf;
                }
            }
        }
    }
}

}  // namespace

Mesh nef_boolean(const Scene& scene, const solid::Geometry& geometry) {
    Nef all;
    for (const PartId id : solid_parts(scene)) {
        const Part& part = scene.parts[id];
        std::map<std::uint32_t, Nef> values;
        for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
            const Expression& e = scene.expressions[i];
            Nef value;
            if (e.kind == ExpressionKind::Leaf) {
                const solid::PlacedLeaf& leaf = geometry.leaves[e.leaf];
                value = to_nef(leaf.points, leaf.triangles);
            }
            const auto children = scene.children(e);
            for (std::size_t k = 0; k < children.size(); ++k) {
                auto child = values.extract(children[k]);
                if (k == 0)
                    value = std::move(child.mapped());
                else if (e.kind == ExpressionKind::Union)
                    value += child.mapped();
                else if (e.kind == ExpressionKind::Intersection)
                    value *= child.mapped();
                else
                    value -= child.mapped();
            }
            values.emplace(i, value.regularization());
        }
        all += values.at(part.root);
    }
    Mesh mesh = to_mesh(all.regularization());
    find_sources(mesh, geometry);
    return mesh;
}

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
