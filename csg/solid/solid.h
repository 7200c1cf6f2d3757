// Closed triangle meshes of the leaves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "csg/tree/box.h"
#include "csg/tree/leaf_shape.h"

namespace csg::solid {

/// About as many as a shape or a file may give.
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 24;

/// A triangle mesh in leaf coordinates, oriented counter-clockwise seen from outside. Meshes made from cube, sphere
/// and cylinder are closed and convex. A polyhedron is taken as given: where it is open, non-manifold or inside out,
/// `warnings` says so and pictures use the even-odd rule along the ray (DESIGN, rule 6).
struct Solid {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    Box box;
    bool convex = false;  ///< Computed, never declared. A convex solid is closed and oriented outwards.
    bool flat = false;    ///< An outline, drawn as a slab about z = 0; it stays 1 thick whatever its transform.
    bool closed = false;  ///< Every directed edge has exactly one opposite.
    std::vector<std::string> warnings;
};

/// The number of segments of a circle of radius `r`: OpenSCAD's rule for $fn, $fa and $fs.
[[nodiscard]] int circle_segments(double r, const Fineness& fineness);

/// Tessellates `shape` exactly as OpenSCAD does (same vertices, in double precision with exact degree
/// trigonometry). A shape without volume gives a Solid without triangles, and so do outlines and files: see placed.h.
[[nodiscard]] std::shared_ptr<const Solid> make_solid(const LeafShape& shape);

}  // namespace csg::solid
