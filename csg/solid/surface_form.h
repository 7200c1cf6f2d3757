// What surface a triangle of a leaf stands for: a plane, a cylinder, a cone, a sphere or a torus, with its measures.
//
// The tree knows them exactly: radii of its shapes, moved by the matrices above them, where these keep what is round
// round. For what it does not know (polyhedra, files, offsets) they are fitted to the facets about the triangle.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace csg::solid {

enum class FormKind : std::uint8_t { Plane, Cylinder, Cone, Sphere, Torus };

/// "plane", "cylinder", …
[[nodiscard]] const char* name(FormKind kind);

/// World coordinates and units.
struct SurfaceForm {
    FormKind kind = FormKind::Plane;
    glm::dvec3 point{0.0};          ///< Of the plane; of a cylinder's axis; a cone's apex; else the center.
    glm::dvec3 direction{0, 0, 1};  ///< Of length 1: out of the leaf; along the axis, of a cone from the apex into it.
    double radius = 0;              ///< Of cylinder and sphere; of the tube of a torus.
    double ring_radius = 0;         ///< Of a torus: from its axis to the middle of the tube.
    double half_angle = 0;          ///< Of a cone, in radians: between axis and mantle.
    int segments = 0;               ///< Of the polygon that stands for its circle; 0: not known.
    bool exact = true;              ///< By the numbers of the tree; else fitted …
    double deviation = 0;           ///< … and no corner that it was fitted to is further from it.
    std::string remark;             ///< Why it is but the plane of a facet; empty of what is flat.
};

/// Of a triangle of a placed leaf. What is bent and has no such surface is the plane of its facet, with a remark.
[[nodiscard]] SurfaceForm form_of(const Tree& tree, const Scene& scene, const Geometry& geometry, LeafId leaf,
                                  std::uint32_t triangle);

// round_shapes.cpp

/// A surface of a shape below a leaf, in the world.
struct RoundShape {
    SurfaceForm form;
    double step = 0;  ///< The longest side of its facets across the axis; of spheres, of their facets.
};

/// The round surfaces of the shapes that a leaf is made of, as far as they are its surfaces where they reach it:
/// cylinders and spheres below hulls, circles that are extruded. `uneven` is told why one of them is not round.
[[nodiscard]] std::vector<RoundShape> round_shapes(const Tree& tree, const LeafInstance& leaf, std::string& uneven);

// fit_form.cpp

/// A facet and those about it.
struct FacetPatch {
    std::vector<glm::dvec3> corners;
    std::vector<glm::dvec3> normals;    ///< One of each facet, outwards, …
    std::vector<glm::dvec3> on_facets;  ///< … and a point of it.
};

/// The sphere, cylinder or cone that all corners lie on, next to exactly; nothing where none is, or the facets are too
/// few to tell.
[[nodiscard]] std::optional<SurfaceForm> fitted_form(const FacetPatch& patch);

}  // namespace csg::solid
