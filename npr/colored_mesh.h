// Parts as meshes, for what is drawn of triangles instead of layers.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace npr {

/// Triangles of several parts in world coordinates, counter-clockwise seen from outside.
struct ColoredMesh {
    /// Of which surface of the model a triangle is.
    struct Face {
        std::uint32_t leaf = 0, plane = 0;
        bool reversed = false;  ///< Of a subtracted leaf.
    };
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::vec4> colors;     ///< By triangle: sRGB, not lit, straight alpha.
    std::vector<std::uint32_t> parts;  ///< By triangle, in ascending order; parts share no points.
    std::vector<Face> faces;           ///< By triangle.
};

}  // namespace npr
