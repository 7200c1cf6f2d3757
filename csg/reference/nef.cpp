#include "csg/reference/nef.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/minkowski_sum_3.h>

#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "csg/reference/expression_value.h"
#include "csg/reference/hull.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

Nef to_nef(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& triangles) {
    PointIds ids;
    std::vector<Kernel::Point_3> soup_points;
    std::vector<std::vector<std::size_t>> faces;
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
    CGAL::Polygon_mesh_processing::orient_polygon_soup(soup_points, faces);
    Polyhedron surface;
    if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(faces))
        throw std::runtime_error("an operand's faces do not form a surface");
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup_points, faces, surface);
    if (!CGAL::is_closed(surface))
        throw std::runtime_error("an operand's surface is not closed");
    Nef nef(surface);
    return nef.is_bounded() ? nef : nef.complement();
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

Mesh minkowski_sum(std::span<const Mesh> operands) {
    Mesh sum;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        if (i == 0) {
            sum = operands[0];
        } else if (convex(sum) && convex(operands[i])) {
            std::vector<glm::dvec3> points;
            points.reserve(sum.points.size() * operands[i].points.size());
            for (const glm::dvec3& p : sum.points) {
                for (const glm::dvec3& q : operands[i].points)
                    points.push_back(p + q);
            }
            sum = hull(points);
        } else {
            Nef a = to_nef(sum.points, sum.triangles), b = to_nef(operands[i].points, operands[i].triangles);
            sum = a.is_empty() || b.is_empty() ? Mesh{} : to_mesh(CGAL::minkowski_sum_3(a, b).regularization());
        }
    }
    sum.sources.assign(sum.triangles.size(), 0);
    return sum;
}

}  // namespace csg::reference
