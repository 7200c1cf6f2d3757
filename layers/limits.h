// How many layers there may be.
#pragma once

namespace layers {

/// In place of a number of layers: as many as there are.
inline constexpr int kAllLayers = 0;
/// The most that can be asked for by number.
inline constexpr int kMostLayers = 65535;
/// The most by which a style's control is set; beyond, all are meant.
inline constexpr int kMostLayersOfControl = 64;

/// What shaders and C++ agree on.
struct LayerLimits {
#include "layers/limits.glsl"
};

/// See layers/limits.glsl.
inline constexpr int kLayersApart = LayerLimits().kLayersApart;

}  // namespace layers
