// Triangle meshes of results: plain data, no CGAL.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "csg/tree/box.h"

namespace csg::reference {

/// A triangle mesh in world coordinates, counter-clockwise seen from outside. Points that lie at one place but belong
/// to different sheets of the surface (solids that touch along an edge or in a point) are separate points, so that
/// every edge has exactly two triangles.
struct Mesh {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> sources;  ///< By triangle: the leaf (or operand) that it comes from.

    [[nodiscard]] bool empty() const { return triangles.empty(); }
};

/// The largest absolute value of the coordinates of points; 0 of none.
[[nodiscard]] double largest_coordinate(std::span<const glm::dvec3> points);
[[nodiscard]] double largest_coordinate(std::span<const Mesh> meshes);

/// What a mesh is, for summaries and checks.
struct MeshFacts {
    Box box;
    double area = 0;    ///< Square world units.
    double volume = 0;  ///< Cubic world units; negative for a mesh turned inside out.
    std::size_t components = 0;
    long genus = 0;  ///< Handles of all components together; only of a closed mesh.
    /// Every directed edge occurs once and its opposite once, no triangle has two equal corners.
    bool manifold = false;
};

[[nodiscard]] MeshFacts facts(const Mesh& mesh);

/// Of two meshes beside each other as one.
[[nodiscard]] MeshFacts both(const MeshFacts& a, const MeshFacts& b);

}  // namespace csg::reference
