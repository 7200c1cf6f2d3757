#include "csg/reference/roof.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include <stdexcept>

#include "base/stop.h"
#include "csg/reference/point_ids.h"
#include "csg/solid/triangulate.h"
#include "csg/solid/triangulate_region.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Region = CGAL::Polygon_with_holes_2<Kernel>;

Polygon polygon_of(const std::vector<glm::dvec2>& loop) {
    Polygon polygon;
    for (const glm::dvec2& p : loop) {
        polygon.push_back({p.x, p.y});
    }
    return polygon;
}

/// Each outer loop with the holes in it.
std::vector<Region> regions_of(std::span<const std::vector<glm::dvec2>> loops) {
    std::vector<Region> regions;
    for (const auto& loop : loops) {
        Polygon polygon = polygon_of(loop);
        if (!polygon.is_simple()) {
            throw std::runtime_error("an outline touches itself");
        }
        if (polygon.is_counterclockwise_oriented()) {
            regions.emplace_back(std::move(polygon));
        }
    }
    for (const auto& loop : loops) {
        Polygon hole = polygon_of(loop);
        if (hole.is_counterclockwise_oriented()) {
            continue;
        }
        Region* around = nullptr;
        for (Region& region : regions) {
            const Polygon& outer = region.outer_boundary();
            if (!outer.has_on_unbounded_side(hole[0]) &&
                (around == nullptr || outer.area() < around->outer_boundary().area())) {
                around = &region;
            }
        }
        if (around == nullptr) {
            throw std::runtime_error("a hole lies in nothing");
        }
        around->add_hole(hole);
    }
    return regions;
}

/// Null where there is none.
auto skeleton_of(const Region& region) {
    try {
        return CGAL::create_interior_straight_skeleton_2(region);
    } catch (const std::logic_error&) {  // CGAL's: its text says nothing about the outline
        throw std::runtime_error("no straight skeleton was found");
    }
}

}  // namespace

Mesh roof(std::span<const std::vector<glm::dvec2>> loops, const std::stop_token& stop) {
    Mesh mesh;
    PointIds known;
    const auto point = [&](double x, double y, double z) {
        const auto [id, added] = known.add({x, y, z});
        if (added) {
            mesh.points.emplace_back(x, y, z);
        }
        return id;
    };
    for (const Region& region : regions_of(loops)) {
        base::end_if_asked(stop);
        const auto skeleton = skeleton_of(region);
        if (!skeleton) {
            throw std::runtime_error("no straight skeleton was found");
        }
        for (auto face = skeleton->faces_begin(); face != skeleton->faces_end(); ++face) {
            std::vector<std::uint32_t> corners;
            auto edge = face->halfedge();
            do {
                const auto vertex = edge->vertex();
                corners.push_back(point(vertex->point().x(), vertex->point().y(), vertex->time()));
                edge = edge->next();
            } while (edge != face->halfedge());
            solid::triangulate(mesh.points, corners, mesh.triangles);
        }
    }
    // The floor, seen from below.
    const solid::IndexedOutline floor = solid::index_corners({{loops.begin(), loops.end()}});
    std::vector<std::uint32_t> ids;
    for (const glm::dvec2& p : floor.points) {
        ids.push_back(point(p.x, p.y, 0));
    }
    for (const glm::uvec3& t : solid::triangulate_region(floor)) {
        mesh.triangles.emplace_back(ids[t.x], ids[t.z], ids[t.y]);
    }
    mesh.sources.assign(mesh.triangles.size(), 0);
    return mesh;
}

}  // namespace csg::reference
