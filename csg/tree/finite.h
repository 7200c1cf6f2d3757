// Whether coordinates are numbers that can be worked with.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace csg {

/// Neither NaN nor infinite in any coordinate.
template <int kSize>
[[nodiscard]] bool is_finite(const glm::vec<kSize, double>& p) {
    for (int i = 0; i < kSize; ++i) {
        if (!std::isfinite(p[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace csg
