// A scene's solid as one closed mesh.
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// How a mesh was found.
enum class Method {
    Planes,  ///< Arrangement of the canonical planes, in one step for the whole expression.
    Nef,     ///< Nef polyhedra in exact arithmetic, operation by operation.
};

[[nodiscard]] const char* name(Method method);

struct BooleanRequest {
    std::optional<Method> method;  ///< Absent: planes, and Nef polyhedra where they cannot decide.
    unsigned threads = 0;          ///< 0: one a core.
    std::stop_token stop{};        ///< Where it is asked for, base::Stopped is thrown.
};

struct BooleanResult {
    Mesh mesh;  ///< Empty where the solid is; `sources` are leaves of the scene.
    MeshFacts facts;
    Method method = Method::Planes;
    std::string reason;  ///< Why not planes; empty where they did.
};

/// The union of the scene's solid and translucent parts, regularised (DESIGN, section 3): coincident faces are those on
/// one plane of `geometry`'s table. A leaf holds a point where a ray from there meets it an odd number of times.
/// Every result has been checked: it is closed and manifold, holds a positive volume, and no two of its triangles cross
/// by more than rounding (self_intersection.h). Throws std::runtime_error where no method gives such a mesh, with the
/// reason, and base::Stopped where it was asked for.
[[nodiscard]] BooleanResult make_mesh(const Scene& scene, const solid::Geometry& geometry,
                                      const BooleanRequest& request = {});

}  // namespace csg::reference
