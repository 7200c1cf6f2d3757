#include "csg/reference/boolean.h"

#include <fmt/format.h>

#include <stdexcept>

#include "base/stop.h"
#include "csg/reference/nef.h"
#include "csg/reference/plane_boolean.h"
#include "csg/reference/plane_cells.h"
#include "csg/reference/self_intersection.h"

namespace csg::reference {
namespace {

/// Of the scene's diagonal: far above the rounding of coordinates, far below anything modelled on purpose.
constexpr double kCrossing = 1e-8;

MeshFacts checked(const Mesh& mesh, const std::stop_token& stop) {
    MeshFacts f = facts(mesh);
    if (!f.manifold)
        throw Undecided("the surface is not closed");
    if (!mesh.empty() && !(f.volume > 0))
        throw Undecided("the surface encloses no volume");
    base::end_if_asked(stop);
    if (count_self_intersections(mesh, kCrossing * f.box.diagonal(), stop) != 0)
        throw Undecided("the surface crosses itself");
    return f;
}

}  // namespace

const char* name(Method method) {
    return method == Method::Planes ? "planes" : "nef";
}

BooleanResult make_mesh(const Scene& scene, const solid::Geometry& geometry, const BooleanRequest& request) {
    BooleanResult result;
    if (request.method != Method::Nef) {
        try {
            result.mesh = plane_boolean(scene, geometry, request.threads, request.stop);
            result.facts = checked(result.mesh, request.stop);
            return result;
        } catch (const Undecided& undecided) {
            result.reason = undecided.what();
            if (request.method)
                throw std::runtime_error(fmt::format("no mesh: {}", result.reason));
        }
    }
    result.method = Method::Nef;
    try {
        result.mesh = nef_boolean(scene, geometry);
        result.facts = checked(result.mesh, request.stop);
    } catch (const std::logic_error& error) {  // a precondition of CGAL
        throw std::runtime_error(fmt::format("no mesh: {}", error.what()));
    }
    return result;
}

}  // namespace csg::reference
