// Shading that does not show the facets of smooth surfaces.
#pragma once

#include "npr/picture.h"

namespace npr {

/// Whether surfaces are shaded by the normals of the smooth surfaces that their facets stand for
/// (npr/smooth_normal.glsl), of a field `smooth_shading`.
[[nodiscard]] Parameter smooth_surfaces(std::string_view name = "smooth", bool initial = true);

/// Does the picture, or a part of it, ask for it? Its surface table must know the facets then.
[[nodiscard]] bool shades_smoothly(const Picture& picture);

}  // namespace npr
