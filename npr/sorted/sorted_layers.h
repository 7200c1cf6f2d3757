// Triangles as a stack of layers, so that styles can color them.
#pragma once

#include <memory>
#include <vector>

#include "base/camera.h"
#include "layers/host_stack.h"
#include "npr/colored_mesh.h"

namespace npr {

/// All of a mesh's triangles behind each pixel, nearest first, but for those of no opacity.
struct SortedLayers {
    layers::HostStack stack;
    std::vector<std::vector<std::uint32_t>> triangles;  ///< By layer, then by pixel; anything where there is none.
};

/// Fills `to`. `table`: what the leaves and planes of the mesh's faces look like.
void draw_layers(const ColoredMesh& mesh, const base::View& view,
                 const std::shared_ptr<const layers::SurfaceTable>& table, SortedLayers& to);

}  // namespace npr
