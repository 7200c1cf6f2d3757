// The parameters of a leaf of the CSG tree, as the language gives them; csg/solid turns them into closed meshes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <variant>
#include <vector>

namespace csg {

/// OpenSCAD's $fn, $fa (degrees) and $fs (model units): how finely a curved leaf is tessellated.
struct Fineness {
    double fn = 0;
    double fa = 12;
    double fs = 2;
    bool operator==(const Fineness&) const = default;
};

/// A box from the origin, or about it.
struct Cube {
    glm::dvec3 size{1.0};
    bool center = false;
    bool operator==(const Cube&) const = default;
};

/// A sphere about the origin.
struct Sphere {
    double radius = 1;
    Fineness fineness;
    bool operator==(const Sphere&) const = default;
};

/// A truncated cone along +z: `radius1` below, `radius2` above.
struct Cylinder {
    double height = 1;
    double radius1 = 1;
    double radius2 = 1;
    bool center = false;
    Fineness fineness;
    bool operator==(const Cylinder&) const = default;
};

/// A mesh given by hand. Faces are loops of point indices, clockwise seen from outside (OpenSCAD's orientation).
struct Polyhedron {
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    unsigned convexity = 1;  ///< Kept for the .csg text only; never believed.
    bool operator==(const Polyhedron&) const = default;
};

/// Polyhedra are shared, not copied.
using LeafShape = std::variant<Cube, Sphere, Cylinder, std::shared_ptr<const Polyhedron>>;

/// A hash of kind and parameters; equal shapes have equal hashes in every run.
[[nodiscard]] std::uint64_t content_hash(const LeafShape& shape);

}  // namespace csg
