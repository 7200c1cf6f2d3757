// The flat faces of a mesh and the edges between them. Internal to csg/solid.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "csg/solid/solid.h"

namespace csg::solid {

/// Where two triangles of different faces meet.
struct MeshEdge {
    std::uint32_t from = 0, to = 0;  ///< Points, in the direction that the first triangle has them in.
    std::uint32_t triangles[2]{};
    float degrees = 0;  ///< Between their normals; negative where the edge is hollow.
};

/// Triangles with a common edge that lie in a plane, or have no area to tell theirs, are one face. An edge that has not
/// two triangles in opposite directions ends the faces on it, and is not among the edges.
class MeshFaces {
  public:
    explicit MeshFaces(const Solid& solid);

    [[nodiscard]] const std::vector<MeshEdge>& edges() const { return edges_; }
    [[nodiscard]] std::uint32_t face_of(std::uint32_t triangle) const { return face_of_[triangle]; }
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Indices of the edges around a face.
    [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t face) const {
        return std::span(around_).subspan(first_[face], first_[face + 1] - first_[face]);
    }
    /// The face of an edge on one side, 0 or 1.
    [[nodiscard]] std::uint32_t side(const MeshEdge& edge, int i) const { return face_of_[edge.triangles[i]]; }

  private:
    void find_edges(const Solid& solid);
    void unite_flat(const Solid& solid);
    void sort_around();

    std::vector<MeshEdge> edges_;
    std::vector<std::uint32_t> face_of_;  ///< By triangle.
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> first_, around_;
};

/// Sets of numbers that are united.
class Sets {
  public:
    explicit Sets(std::size_t count);
    [[nodiscard]] std::uint32_t find(std::uint32_t i);
    void unite(std::uint32_t a, std::uint32_t b);
    /// The set of each as a number from 0 on, in order of their first members; and how many there are.
    [[nodiscard]] std::vector<std::uint32_t> numbers(std::uint32_t& count);

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace csg::solid
