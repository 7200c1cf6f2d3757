// Trigonometry in degrees, exact where the result is rational.
#pragma once

namespace csg {

/// Sine and cosine of an angle in degrees. Multiples of 30 whose sine is 0, ±1/2 or ±1 are exact, and the symmetries
/// sin(x) = sin(180 - x) = -sin(x + 180) and cos(x) = sin(x + 90) hold to the last bit from 0 to 360, so that vertices
/// of a circle mirror each other; other angles are first brought there. All results are OpenSCAD's to the last bit. NaN
/// for angles that are not finite, or so large that doubles do not tell degrees apart.
[[nodiscard]] double sin_degrees(double degrees);
[[nodiscard]] double cos_degrees(double degrees);
[[nodiscard]] double tan_degrees(double degrees);

/// Arcs in degrees; whole degrees where the function takes these to exactly the value.
[[nodiscard]] double asin_degrees(double x);
[[nodiscard]] double acos_degrees(double x);
[[nodiscard]] double atan_degrees(double x);
[[nodiscard]] double atan2_degrees(double y, double x);

}  // namespace csg
