// Closed triangle meshes of the leaves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "csg/solid/smooth_groups.h"
#include "csg/tree/box.h"
#include "csg/tree/leaf_shape.h"

namespace csg::solid {

/// About as many as a shape or a file may give.
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 24;

/// A triangle mesh in leaf coordinates, oriented counter-clockwise seen from outside. Meshes made from cube, sphere
/// and cylinder are closed and convex. A polyhedron is taken as given. What is inside follows from `closed`: of a
/// closed mesh the points with a winding number that is not zero (so a mesh turned inside out is the same solid, and
/// shells that overlap are solid throughout), of any other mesh those from which a ray meets it an odd number of times,
/// and then `warnings` says so. `failures` tell what of the shape that was asked for is missing, and why.
struct Solid {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    std::vector<FacetGroup> groups;  ///< By triangle; none: each plane is a surface of its own.
    /// Are the groups only told by the angles of the mesh?
    bool groups_estimated = false;
    Box box;
    bool convex = false;  ///< Computed, never declared. A convex solid is closed and oriented outwards.
    bool flat = false;    ///< An outline, drawn as a slab about z = 0; it stays 1 thick whatever its transform.
    bool closed =
        false;  ///< Each directed edge occurs as often as its opposite (an edge may have more than two faces).
    /// Known to have no winding numbers but 0 and one more, 1 or -1: then parity along a ray tells what is inside. So
    /// it is by construction for most shapes; for meshes given by hand it is only known where they are convex.
    bool simple = false;
    std::vector<std::string> warnings, failures;

    /// Must directions be counted along a ray to tell what is inside?
    [[nodiscard]] bool winds() const { return closed && !simple; }
};

/// The number of segments of a circle of radius `r`: OpenSCAD's rule for $fn, $fa and $fs.
[[nodiscard]] int circle_segments(double r, const Fineness& fineness);

/// Why a circle of that fineness would have fewer segments than $fn asks for; empty where it has as many.
[[nodiscard]] std::string too_fine(const Fineness& fineness);

/// Tessellates `shape` exactly as OpenSCAD does (same vertices, in double precision with exact degree
/// trigonometry). A shape without volume gives a Solid without triangles, and so do outlines and files: see placed.h.
[[nodiscard]] std::shared_ptr<const Solid> make_solid(const LeafShape& shape);

}  // namespace csg::solid
