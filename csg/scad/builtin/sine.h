// Sine and cosine with OpenSCAD's signs of zero.
#pragma once

#include <cmath>

#include "csg/tree/degrees.h"

namespace csg::scad {

/// From 0 up to 360, for a finite angle.
[[nodiscard]] inline double within_turn(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    return rest < 0 ? rest + 360 : rest;
}

/// As sin_degrees, but -0 after half a turn. Printed matrices and atan2() show the difference.
[[nodiscard]] inline double sine(double degrees) {
    const double s = sin_degrees(degrees);
    return s == 0 && within_turn(degrees) == 180 ? -0.0 : s;
}

/// As cos_degrees, but -0 after three quarters of a turn.
[[nodiscard]] inline double cosine(double degrees) {
    const double c = cos_degrees(degrees);
    return c == 0 && within_turn(degrees) == 270 ? -0.0 : c;
}

}  // namespace csg::scad
