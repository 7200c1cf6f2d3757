#include "csg/reference/boolean.h"

#include <fmt/format.h>

#include <stdexcept>

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
    result.mesh = plane_boolean(scene, geometry, request.threads);
    check(result.mesh);
    return result;
}

}  // namespace csg::reference
