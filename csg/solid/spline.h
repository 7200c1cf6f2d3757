// Rational B-splines in the plane.
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/outline.h"

namespace csg::solid {

struct Spline {
    int degree = 3;
    std::vector<double> knots;  ///< As many as points, and degree + 1 more; none falls.
    Loop points;
    std::vector<double> weights;  ///< One for each point, above 0; none: all 1.
};

/// Points along the spline from its first to its last valid parameter, `steps` for each span between different knots
/// (de Boor 1972). Nothing where numbers do not fit together, or a degree is not from 1 to 15.
[[nodiscard]] std::optional<Loop> points_along(const Spline& spline, int steps);

}  // namespace csg::solid
