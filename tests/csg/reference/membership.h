// Whether a mesh holds the points that its model does: by winding numbers from solid angles, which share nothing with
// what made the mesh.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "csg/reference/mesh.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace meshes {

/// How often the triangles wind around the point.
[[nodiscard]] int winding_number(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
                                 const glm::dvec3& point);

/// Of so many points spread over the box (the same ones every time), those that the mesh holds and the scene does not,
/// or the other way around. The scene's leaves are closed.
[[nodiscard]] std::size_t count_wrong_points(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                                             const csg::reference::Mesh& mesh, const csg::Box& box, std::size_t count);

}  // namespace meshes
