// All surfaces of a mesh behind each pixel: the plain truth that pictures are compared with.
#pragma once

#include <cstdint>
#include <vector>

#include "base/camera.h"
#include "csg/reference/mesh.h"

namespace ui {

/// One surface along the ray of a pixel.
struct MeshSurface {
    double distance = 0;  ///< From the eye's plane, as in base::View.
    std::uint32_t triangle = 0;
};

/// surfaces of pixel (x, y): of[y * width + x], nearest first; rows from bottom to top.
struct MeshLayers {
    glm::ivec2 size{0};
    std::vector<std::vector<MeshSurface>> of;
};

/// Casts the ray of each pixel's sample at the triangles, in double precision. Nothing is shared with the engines: no
/// planes, no snapping, no expression. A sample on an edge belongs to one of the two triangles that meet there.
[[nodiscard]] MeshLayers mesh_layers(const csg::reference::Mesh& mesh, const base::View& view);

}  // namespace ui
