// OpenSCAD's preview.
#pragma once

#include "npr/style.h"

namespace npr {

[[nodiscard]] StyleInfo shaded_style();

}  // namespace npr
