// The volume of a solid by its picture.
#pragma once

#include "base/camera.h"
#include "layers/host_stack.h"

namespace ui {

struct LayerVolume {
    double volume = 0;       ///< World units, cubed.
    double uncertainty = 0;  ///< What may lie between the samples: half of what neighboring samples differ by.
};

/// Adds up how long the rays run inside. `stack` holds all layers of an orthographic view of all of the solid. Rays
/// that end inside, as those of open meshes do, count only as far as their last surface.
[[nodiscard]] LayerVolume layer_volume(const layers::HostStack& stack, const base::View& view);

}  // namespace ui
