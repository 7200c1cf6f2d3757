#include "csg/reference/boolean.h"

#include <fmt/format.h>

#include <stdexcept>

#include "csg/reference/nef.h"
#include "csg/reference/plane_boolean.h"
#include "csg/reference/plane_cells.h"

namespace csg::reference {
namespace {

void check(const Mesh& mesh) {
    const MeshFacts f = facts(mesh);
    if (!f.manifold)
        throw Undecided("the surface is not closed");
    if (!mesh.empty() && !(f.volume > 0))
        throw Undecided("the surface encloses no volume");
}

}  // namespace

const char* name(Method method) {
    return method == Method::Planes ? "planes" : "nef";
}

BooleanResult make_mesh(const Scene& scene, const solid::Geometry& geometry, const BooleanRequest& request) {
    BooleanResult result;
    if (request.method != Method::Nef) {
        try {
            result.mesh = plane_boolean(scene, geometry, request.threads);
            check(result.mesh);
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
        check(result.mesh);
    } catch (const std::logic_error& error) {  // a precondition of CGAL
        throw std::runtime_error(fmt::format("no mesh: {}", error.what()));
    }
    return result;
}

}  // namespace csg::reference
