// View-dependent transparency without OpenGL (npr/shine/shine_map.h does it with).
#pragma once

#include <vector>

#include "npr/painter/cpu_frame.h"

namespace npr {

/// For CpuFrame::shine.
[[nodiscard]] std::vector<ShineRow> find_shine(const CpuFrame& frame);

}  // namespace npr
