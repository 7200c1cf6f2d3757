// A scene's solid as one closed mesh.
#pragma once

#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::reference {

/// How a mesh was found.
enum class Method {
    Copy,    ///< No leaf meets another or itself.
    Planes,  ///< Arrangement of the canonical planes, in one step for the whole expression.
    Exact,   ///< Arrangement of all triangles in exact arithmetic, in one step as well.
};

[[nodiscard]] const char* name(Method method);

struct BooleanRequest {
    std::optional<Method> method;  ///< Absent: what is found as it is, then planes, then exact arithmetic.
    unsigned threads = 0;          ///< 0: one a core.
    std::stop_token stop{};        ///< Where it is asked for, base::Stopped is thrown.
};

struct BooleanResult {
    Mesh mesh;  ///< Empty where the solid is; `sources` are leaves of the scene.
    MeshFacts facts;
    Method method = Method::Planes;  ///< The last of the enumeration that some group of leaves (leaf_groups.h) took.
    std::string reason;              ///< Why not planes; empty where they did.
};

/// What keeps a leaf from being combined.
class LeafError : public std::runtime_error {
  public:
    LeafError(LeafId leaf, const std::string& text) : std::runtime_error(text), leaf_(leaf) {}
    [[nodiscard]] LeafId leaf() const { return leaf_; }

  private:
    LeafId leaf_;
};

/// The union of the scene's solid and translucent parts, regularized (DESIGN, section 3): coincident faces are those on
/// one plane of `geometry`'s table, or in exact arithmetic those that are in one plane. What is inside a leaf is told
/// by its winding number, or where its faces are not oriented alike by evenness (winding.h). Every result has been
/// checked: it is closed and manifold, holds a positive volume (or is empty), and no two of its triangles cross by more
/// than rounding (self_intersection.h). The one exception: a leaf whose surface is open is in the result as it is where
/// it is united with others only and apart from them; else LeafError is thrown. Throws std::runtime_error where no
/// method gives such a mesh, with the reason, and base::Stopped where it was asked for.
[[nodiscard]] BooleanResult make_mesh(const Scene& scene, const solid::Geometry& geometry,
                                      const BooleanRequest& request = {});

}  // namespace csg::reference
