// Things of a model that can be measured: places, faces, edges and corners, and what lies between two of them.
//
// How a window uses it: a click gives a PickedSurface (Renderer::pick); measured_face(model, picked) is what was
// clicked, and EdgeFinder(model), kept as long as the model is, finds the edge or the corner next to it. Two of them
// give a Relation. measured_text.h says all of it in words. Nothing here draws, and all of it is const: it may run in
// any thread.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "csg/solid/surface_form.h"
#include "ui/pipeline/inspection/solid_probe.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/picture/pick.h"

namespace ui {

/// World coordinates and units (mm).
struct Measured {
    enum class Kind : std::uint8_t {
        Point,   ///< A place, or a corner.
        Edge,    ///< A straight one, from `from` to `to`.
        Circle,  ///< A round one: where a face ends across its axis. `form`: center, axis, radius.
        Face,    ///< `form`
    };
    Kind kind = Kind::Point;
    glm::dvec3 at{0.0};  ///< Where it was named: on it, or beside the edge or corner. Of a Point, itself.
    glm::dvec3 from{0.0}, to{0.0};
    csg::solid::SurfaceForm form;
    std::optional<csg::LeafId> leaf;  ///< That made the face; of edges, one of two.

    /// Along an edge or an axis, across a plane; of length 1. Nothing of points and spheres.
    [[nodiscard]] std::optional<glm::dvec3> direction() const;
    /// Nothing of points, planes, edges and cones.
    [[nodiscard]] std::optional<double> radius() const;
};

/// The triangle of its leaf that a picked place lies on.
[[nodiscard]] std::uint32_t triangle_at(const Model& model, const PickedSurface& picked);

[[nodiscard]] Measured measured_point(const glm::dvec3& point);

/// The face that was picked. Its plane's normal points out of the part.
[[nodiscard]] Measured measured_face(const Model& model, const PickedSurface& picked);

/// A leaf's triangle that looks that way the most; `at` is in its middle. `towards` of any length.
[[nodiscard]] Measured measured_face(const Model& model, csg::LeafId leaf, const glm::dvec3& towards);

/// The one bent surface of a leaf, which a cylinder, a cone, a sphere or an extruded circle has; a facet with a remark
/// where it is not round. Nothing of others.
[[nodiscard]] std::optional<Measured> measured_round(const Model& model, csg::LeafId leaf);

/// Finds edges and corners of what a model shows, in its expression: no mesh, no picture. Takes time to make, which
/// grows with the model's triangles.
class EdgeFinder {
  public:
    /// The model must outlive it.
    explicit EdgeFinder(const Model& model);

    /// The edge of the picked face that is next to the place; nothing where it has none. Joints of facets that stand
    /// for one bent surface are no edges.
    [[nodiscard]] std::optional<Measured> edge(const PickedSurface& picked) const;
    /// The same of the ends of the straight edges around the place.
    [[nodiscard]] std::optional<Measured> corner(const PickedSurface& picked) const;

  private:
    [[nodiscard]] std::vector<Measured> edges(const PickedSurface& picked) const;

    const Model& model_;
    ExpressionLinks links_;
    SolidProbe probe_;
};

/// What lies between two things. Points and spheres count by their center, circles too; cylinders and cones by their
/// axis, which has no end; planes have none either, and edges have two.
struct Relation {
    std::optional<double> distance;  ///< 0 where they meet. Nothing where one is a plane that the other crosses.
    glm::dvec3 from{0.0}, to{0.0};   ///< Where the distance is.
    /// The same between the surfaces of cylinders and spheres, which the distance is to the middle of; the least only
    /// where they are apart. Nothing where neither is one, or axes cross.
    std::optional<double> least, most;
    std::optional<double> degrees;  ///< Between directions, 0 to 90; of two planes between their normals.
    bool parallel = false;          ///< The angle is 0 but for rounding.
};

[[nodiscard]] Relation relation_of(const Measured& a, const Measured& b);

}  // namespace ui
