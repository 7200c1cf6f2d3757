// What lies beyond a picture's border, as far as its lines reach into the picture.
#pragma once

#include "npr/picture.h"

namespace npr {

/// The picture with a band of pixels about it, as wide as its style and those of its parts need (StyleInfo::reach), so
/// that lines at the border are what they are in a larger picture. What is drawn in the band is not shown. The same
/// picture where nobody needs one.
[[nodiscard]] Picture with_guard_band(const Picture& picture);

/// Of edges, whose place depends on what is about them (npr/edges/contour.glsl), with lines of that width on them.
[[nodiscard]] int reach_of_lines(float width);

}  // namespace npr
