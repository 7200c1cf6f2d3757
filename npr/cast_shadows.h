// Shadows that parts cast (Nienhaus 2005, 4.8): whoever makes the layers finds them, for both painters.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"
#include "npr/picture.h"

namespace npr {

/// By layer of a pixel, nearest first from the lowest bit on: does its surface lie in the shadow of a part?
using ShadowBits = std::uint32_t;
/// Deeper layers lie in no shadow.
inline constexpr int kLayersInShadow = 32;

/// By pixel of the layers that were made last, of that view.
using FindShadows = std::function<std::vector<ShadowBits>(const base::View& view)>;

/// Whether shadows are drawn (npr/shadow.glsl), of a field `cast_shadows`.
[[nodiscard]] Parameter shadows_cast(bool initial);

/// Does the picture, or a part of it, ask for them?
[[nodiscard]] bool casts_shadows(const Picture& picture);

/// Where the light is that casts them: a direction of length 1 in the world.
[[nodiscard]] glm::dvec3 toward_light(const base::View& view);

}  // namespace npr
