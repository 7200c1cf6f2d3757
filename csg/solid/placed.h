// The leaves of a scene as meshes in the world, with canonical planes.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "csg/solid/plane_table.h"
#include "csg/solid/solid.h"
#include "csg/tree/scene.h"

namespace csg::solid {

/// One leaf occurrence in the world. A mirroring transform has turned the triangles around, so that they are again
/// counter-clockwise seen from outside.
struct PlacedLeaf {
    std::shared_ptr<const Solid> solid;
    std::vector<glm::dvec3> points;     ///< World coordinates.
    std::vector<glm::uvec3> triangles;  ///< Into `points`.
    std::vector<PlaneRef> planes;       ///< One per triangle.
    Box box;                            ///< World coordinates; empty where the leaf has no volume.
};

/// All leaves of a scene, indexed by LeafId, and their planes.
struct Geometry {
    std::vector<PlacedLeaf> leaves;
    PlaneTable planes;
    Box box;                            ///< Of all leaves together.
    std::vector<std::string> warnings;  ///< With file:line where known.
};

/// Keeps solids by content hash, so that an edit rebuilds only what changed.
class SolidCache {
  public:
    std::shared_ptr<const Solid> get(const LeafShape& shape);
    /// Forgets solids that nobody else holds.
    void trim();

  private:
    std::unordered_map<std::uint64_t, std::shared_ptr<const Solid>> solids_;
};

/// Places every leaf. Transforms run in double precision; a matrix that is not finite or is projective makes the leaf
/// empty, with a warning; one with zero determinant makes it a leaf without volume.
[[nodiscard]] Geometry place(const Tree& tree, const Scene& scene, SolidCache& cache);

}  // namespace csg::solid
