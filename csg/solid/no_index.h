#pragma once

#include <cstdint>

namespace csg::solid {

inline constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< No point, plane or triangle.

}  // namespace csg::solid
