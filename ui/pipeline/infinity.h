#pragma once

#include <limits>

namespace ui {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace ui
