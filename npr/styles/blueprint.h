// Edges of all layers, like light through paper.
#pragma once

#include "npr/style.h"

namespace npr {

[[nodiscard]] StyleInfo blueprint_style();

}  // namespace npr
