#include "csg/reference/boolean.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/stop.h"
#include "csg/reference/complex_surface.h"
#include "csg/reference/exact_boolean.h"
#include "csg/reference/open_leaves.h"
#include "csg/reference/plane_boolean.h"
#include "csg/reference/segments.h"
#include "csg/reference/self_intersection.h"

namespace csg::reference {
namespace {

/// Of the scene's diagonal: far above the rounding of coordinates, far below anything modelled on purpose.
constexpr double kCrossing = 1e-8;
/// Of the result's diagonal: where planes that near to each other are one, details are lost.
constexpr double kCoarse = 1e-5;
/// Products of four coordinates are numbers.
constexpr double kLargest = 1e75;

MeshFacts checked(const Mesh& mesh, Overlaps overlaps, const std::stop_token& stop) {
    MeshFacts f = facts(mesh);
    if (!f.manifold)
        throw Undecided("the surface is not closed");
    if (!mesh.empty() && !(f.volume > 0))
        throw Undecided("the surface encloses no volume");
    base::end_if_asked(stop);
    if (count_self_intersections(mesh, kCrossing * f.box.diagonal(), overlaps, stop) != 0)
        throw Undecided("the surface crosses itself");
    return f;
}

BooleanResult by_planes(const Scene& scene, const solid::Geometry& geometry, const BooleanRequest& request) {
    BooleanResult result;
    try {
        result.mesh = plane_boolean(scene, geometry, request.threads, request.stop);
        result.facts = checked(result.mesh, Overlaps::Counted, request.stop);
        const Box& box = result.mesh.empty() ? geometry.box : result.facts.box;
        if (geometry.planes.tolerance() > kCoarse * box.diagonal())
            throw Undecided("the tolerance is too coarse for a solid so small and so far from the origin");
    } catch (const std::logic_error&) {  // CGAL's: its text is of no use here
        throw Undecided("the triangulation of a plane contradicts itself");
    }
    return result;
}

BooleanResult by_exact_arithmetic(const Scene& scene, const solid::Geometry& geometry, const std::stop_token& stop) {
    BooleanResult result;
    result.method = Method::Exact;
    try {
        result.mesh = exact_boolean(scene, geometry, stop);
        result.facts = checked(result.mesh, Overlaps::Ignored, stop);
    } catch (const std::logic_error&) {  // CGAL's
        throw std::runtime_error("no mesh: the arrangement of the faces contradicts itself");
    } catch (const Undecided& undecided) {
        throw std::runtime_error(fmt::format("no mesh: {}", undecided.what()));
    }
    return result;
}

BooleanResult of_closed_leaves(const Scene& scene, const solid::Geometry& geometry, const BooleanRequest& request) {
    std::string reason;
    if (request.method != Method::Exact) {
        try {
            return by_planes(scene, geometry, request);
        } catch (const Undecided& undecided) {
            reason = undecided.what();
            if (request.method)
                throw;
        }
    }
    BooleanResult result = by_exact_arithmetic(scene, geometry, request.stop);
    result.reason = std::move(reason);
    return result;
}

}  // namespace

const char* name(Method method) {
    return method == Method::Planes ? "planes" : "exact";
}

BooleanResult make_mesh(const Scene& scene, const solid::Geometry& geometry, const BooleanRequest& request) {
    const std::vector<LeafId> leaves = leaves_of(scene, geometry), open = open_leaves(geometry, leaves);
    for (const LeafId leaf : leaves) {
        const Box& box = geometry.leaves[leaf].box;
        const glm::dvec3 most = glm::max(glm::abs(box.lo), glm::abs(box.hi));
        if (!(std::max({most.x, most.y, most.z}) <= kLargest))
            throw LeafError(leaf, "it reaches farther than 1e75 from the origin, too far for a mesh");
    }
    if (open.empty())
        return of_closed_leaves(scene, geometry, request);
    for (const LeafId leaf : open) {
        if (!stands_apart(scene, geometry, leaves, leaf))
            throw LeafError(leaf,
                            "its surface is open, so that nothing tells what is inside: it cannot be combined with "
                            "other objects");
    }
    solid::Geometry closed = geometry;
    for (const LeafId leaf : open)
        closed.leaves[leaf].triangles.clear();
    BooleanResult result = of_closed_leaves(scene, closed, request);
    for (const LeafId leaf : open)
        append_leaf(result.mesh, geometry.leaves[leaf], leaf);
    result.facts = facts(result.mesh);
    return result;
}

}  // namespace csg::reference
