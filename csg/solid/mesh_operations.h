// What needs exact booleans of meshes. csg/solid only asks; csg/reference answers (DESIGN, section 1).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "csg/solid/outline.h"

namespace csg::solid {

/// A closed mesh, counter-clockwise seen from outside.
struct Mesh {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
};

/// An empty mesh without a problem is an answer: nothing is left.
struct MeshResult {
    Mesh mesh;
    std::string problem;  ///< Why there is no answer; empty where there is one.
};

/// Implementations are const and may be asked from one thread at a time. They throw base::Stopped soon after `stop`
/// asked for it.
class MeshOperations {
  public:
    virtual ~MeshOperations() = default;
    /// As `combine` of outlines: the first minus the others where it is a difference.
    [[nodiscard]] virtual MeshResult boolean(BooleanKind kind, std::span<const Mesh> operands,
                                             const std::stop_token& stop) const = 0;
    /// The convex hull of points in any number and position; empty where they lie in a plane.
    [[nodiscard]] virtual MeshResult hull(std::span<const glm::dvec3> points, const std::stop_token& stop) const = 0;
    /// The Minkowski sum of operands, each the union of its meshes; empty ones do not count.
    [[nodiscard]] virtual MeshResult minkowski(std::span<const std::vector<Mesh>> operands,
                                               const std::stop_token& stop) const = 0;
    /// A roof over a region: the straight skeleton's, or as high as the nearest point of the outline is far.
    [[nodiscard]] virtual MeshResult roof(const Outline& outline, const Roof& how,
                                          const std::stop_token& stop) const = 0;
};

}  // namespace csg::solid
