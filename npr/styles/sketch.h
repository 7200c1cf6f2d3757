// Drawn by hand (Nienhaus 2005, chapter 6).
#pragma once

#include "npr/style.h"

namespace npr {

[[nodiscard]] StyleInfo sketch_style();

}  // namespace npr
