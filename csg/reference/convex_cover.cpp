#include "csg/reference/convex_cover.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/stop.h"
#include "csg/reference/components.h"
#include "csg/reference/convex_growth.h"
#include "csg/reference/facets.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/solid/plane_table.h"
#include "csg/solid/winding_number.h"

namespace csg::reference {
namespace {

/// The hull, where it holds no more than the mesh and a skin as thick as what makes planes one.
std::optional<Convex> convex_but_for_rounding(const Mesh& mesh, const MeshFacts& known, const std::stop_token& stop) {
    if (!known.manifold || !(known.volume > 0)) {
        return {};
    }
    Convex full = Convex::hull_of(mesh.points, stop);
    const MeshFacts f = facts({full.points(), full.triangles(), {}});
    const glm::dvec3 largest = glm::max(glm::abs(known.box.lo), glm::abs(known.box.hi));
    const double skin = solid::coincidence_tolerance(std::max({largest.x, largest.y, largest.z}));
    if (full.empty() || f.volume - known.volume > skin * f.area) {
        return {};
    }
    return full;
}

/// Closed and evenly oriented, more of it outwards than inwards.
Mesh solid_mesh(const Mesh& mesh, const std::stop_token& stop) {
    Mesh solid = welded(mesh.points, mesh.triangles, mesh.sources);
    if (!balanced(solid)) {
        solid = combine(ExpressionKind::Union, std::span(&mesh, 1), stop).mesh;
    }
    if (facts(solid).volume < 0) {
        for (glm::uvec3& t : solid.triangles) {
            std::swap(t.y, t.z);
        }
    }
    return solid;
}

void add(ConvexCover& cover, Mesh mesh, const std::stop_token& stop) {
    const std::vector<Mesh> components = components_of(mesh);
    std::vector<MeshFacts> known;
    std::transform(components.begin(), components.end(), std::back_inserter(known), facts);
    for (std::size_t i = 0; i < components.size(); ++i) {
        base::end_if_asked(stop);
        cover.points.push_back(components[i].points[0]);
        // Another component that is turned inwards may take from this one.
        bool whole = true;
        for (std::size_t j = 0; j < components.size() && whole; ++j) {
            whole = j == i || known[j].volume >= 0 || !overlap(known[i].box, known[j].box);
        }
        if (std::optional<Convex> piece; whole && (piece = convex_but_for_rounding(components[i], known[i], stop))) {
            cover.points.back() = piece->middle();
            cover.pieces.push_back(std::move(*piece));
            continue;
        }
        for (std::vector<glm::dvec3>& facet : convex_facets(components[i])) {
            cover.pieces.push_back(Convex::polygon(std::move(facet)));
        }
    }
    cover.meshes.push_back(std::move(mesh));
}

}  // namespace

bool ConvexCover::holds(const glm::dvec3& point) const {
    return std::any_of(meshes.begin(), meshes.end(), [&](const Mesh& mesh) {
        return solid::winding_number(mesh.points, mesh.triangles, point) != 0;
    });
}

void grow(ConvexCover& cover, const std::stop_token& stop) {
    std::vector<std::vector<glm::dvec3>> facets;
    for (const Mesh& mesh : cover.meshes) {
        for (std::vector<glm::dvec3>& facet : convex_facets(mesh)) {
            facets.push_back(std::move(facet));
        }
    }
    cover.pieces = grown(
        std::move(cover.pieces), facets, solid::coincidence_tolerance(largest_coordinate(cover.meshes)),
        [&](const glm::dvec3& point) { return cover.holds(point); }, stop);
}

ConvexCover convex_cover(const std::vector<Mesh>& meshes, const std::stop_token& stop) {
    ConvexCover cover;
    for (const Mesh& mesh : meshes) {
        if (Mesh solid = solid_mesh(mesh, stop); !solid.empty()) {
            add(cover, std::move(solid), stop);
        }
    }
    cover.convex = cover.pieces.size() == 1 && !cover.pieces[0].triangles().empty();
    return cover;
}

}  // namespace csg::reference
