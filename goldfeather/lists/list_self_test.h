// Does a driver compute the resolving shaders of the engine `lists` as they are written? A loop in divergent control
// flow has been seen to be miscompiled, which no compiler's log tells.
#pragma once

#include <string>

#include "goldfeather/lists/list_resolver.h"

namespace goldfeather {

/// Resolves lists of all classes, with all that they can hold (several parts, several surfaces at one depth, leaves
/// that are counted from behind; with `windings` also leaves whose directions count), and compares the layers with
/// those that PixelWalk finds on the CPU. Empty where all are equal; otherwise what is wrong.
[[nodiscard]] std::string self_test(const gl::Functions& gl, ListResolver& resolver, bool windings);

}  // namespace goldfeather
