// Surface colors with edges drawn.
#pragma once

#include "npr/style.h"

namespace npr {

[[nodiscard]] StyleInfo edges_style();

}  // namespace npr
