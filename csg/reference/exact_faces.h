// The triangles of all leaves as exact arithmetic sees them: which lie in one plane, and which may meet.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <stop_token>
#include <utility>
#include <vector>

#include "csg/reference/leaf_group.h"
#include "csg/reference/point_table.h"

namespace csg::reference {

/// A triangle with an area, of corners that are doubles. Coordinates are taken to the last bit.
struct ExactFace {
    std::array<std::uint32_t, 3> corners;
    LeafId leaf;
    std::uint32_t plane;
};

/// A plane as some face in it faces. Triangles in one plane whose boxes touch, directly or through others, have the
/// same one; planes apart from each other may be equal.
struct ExactPlane {
    std::uint32_t face;  ///< Whose plane it is.
    int u, v;            ///< Axes of a picture in which what is counter-clockwise about the normal is so.
};

struct ExactFaces {
    PointTable corners;  ///< Corners of leaves that only rounding tells apart are one.
    std::vector<ExactFace> faces;
    std::vector<ExactPlane> planes;
    /// Pairs of faces on different planes, neither of which lies on one side of the other's plane, and which have no
    /// edge in common.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting;
    double largest = 0;  ///< Of all coordinates.

    [[nodiscard]] const glm::dvec3& corner(const ExactFace& face, std::size_t k) const {
        return corners[face.corners[k % 3]];
    }
};

[[nodiscard]] ExactFaces collect_faces(const LeafGroup& group, const std::stop_token& stop);

/// The side of a face's plane that a corner lies on: 1 in front of it, -1 behind it, 0 in it.
[[nodiscard]] int side_of(const ExactFaces& all, const ExactFace& face, std::uint32_t corner);

/// Is a corner in the face's plane within the face, its border included?
[[nodiscard]] bool holds(const ExactFaces& all, const ExactFace& face, std::uint32_t corner);

/// Does the edge, whose ends are on different sides of the face's plane, pass through the face, its border included?
[[nodiscard]] bool pierces(const ExactFaces& all, std::uint32_t from, std::uint32_t to, const ExactFace& face);

}  // namespace csg::reference
