// All layers, translucent, with their edges (Nienhaus 2005, 5.3).
#pragma once

#include "npr/style.h"

namespace npr {

[[nodiscard]] StyleInfo xray_style();

}  // namespace npr
