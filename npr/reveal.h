// Depth masking: peeling away what hides some parts (Nienhaus 2005, 5.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "layers/host_stack.h"
#include "npr/picture.h"

namespace npr {

/// How far a picture's layers are peeled away, so that its `reveal`ed parts are seen.
struct Revealed {
    int layers = 0;    ///< So many surfaces of other parts are taken away, the first ones, at each pixel.
    double share = 0;  ///< Of the pixels that the parts cover, those in which nothing opaque is before them then.
};

/// The fewest layers by which each of the parts comes to its fraction. With all layers; `%`, `#` and what is seen
/// through hide nothing.
[[nodiscard]] Revealed layers_to_peel_away(const Picture& picture, const layers::HostStack& stack);

/// The stack without the first `count` surfaces of parts that are not revealed, at each pixel. A medium of which the
/// nearer surface goes is not there up to the farther one.
void peel_away(const Picture& picture, const layers::HostStack& stack, int count, layers::HostStack& kept);

}  // namespace npr
