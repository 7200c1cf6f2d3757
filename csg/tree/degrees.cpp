#include "csg/tree/degrees.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace csg {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// Sine of 0 to 90 degrees.
double sin_first_quadrant(double x) {
    if (x == 30.0) {
        return 0.5;
    }
    if (x == 45.0) {
        return std::numbers::sqrt2 / 2;
    }
    if (x == 60.0) {
        return std::numbers::sqrt3 / 2;
    }
    if (x < 45.0) {
        return std::sin(x * kRadians);
    }
    return std::cos((90.0 - x) * kRadians);
}

/// Cosine of the same; cos(30) and sin(60) are one value.
double cos_first_quadrant(double x) {
    if (x == 30.0) {
        return std::numbers::sqrt3 / 2;
    }
    if (x == 45.0) {
        return std::numbers::sqrt2 / 2;
    }
    if (x == 60.0) {
        return 0.5;
    }
    if (x > 45.0) {
        return std::sin((90.0 - x) * kRadians);
    }
    return std::cos(x * kRadians);
}

/// From 0 up to `cycle`; NaN where a double no longer tells degrees apart.
double within(double degrees, double cycle) {
    if (degrees >= 0.0 && degrees < cycle) {
        return degrees;
    }
    constexpr double kMost = 0x1p52 * 360.0;
    return std::abs(degrees) < kMost ? degrees - cycle * std::floor(degrees / cycle)
                                     : std::numeric_limits<double>::quiet_NaN();
}

double in_degrees(double radians) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    return radians * kDegrees;
}

/// The whole number of degrees next to `degrees` where it is exactly what `function` takes to `value`.
template <typename Function>
double whole_if_exact(double degrees, Function&& function, double value) {
    const double whole = std::round(degrees);
    return function(whole) == value ? whole : degrees;
}

}  // namespace

double sin_degrees(double degrees) {
    double x = within(degrees, 360.0);
    const bool negative = x >= 180.0;
    if (negative) {
        x -= 180.0;
    }
    const double s = sin_first_quadrant(x > 90.0 ? 180.0 - x : x);
    return negative && s != 0.0 ? -s : s;
}

double cos_degrees(double degrees) {
    double x = within(degrees, 360.0);
    bool negative = x >= 180.0;
    if (negative) {
        x -= 180.0;
    }
    if (x > 90.0) {
        x = 180.0 - x;
        negative = !negative;
    }
    const double c = cos_first_quadrant(x);
    return negative && c != 0.0 ? -c : c;
}

double tan_degrees(double degrees) {
    const double cycles = std::floor(degrees / 180.0);
    double x = within(degrees, 180.0);
    const bool odd = std::fmod(cycles, 2.0) != 0.0;
    if (x == 0.0) {
        return odd ? -0.0 : 0.0;
    }
    if (x == 90.0) {
        return odd ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    }
    const bool negative = x > 90.0;
    if (negative) {
        x = 180.0 - x;
    }
    const double t = x == 30.0   ? std::numbers::inv_sqrt3
                     : x == 45.0 ? 1.0
                     : x == 60.0 ? std::numbers::sqrt3
                                 : std::tan(x * kRadians);
    return negative ? -t : t;
}

double asin_degrees(double x) {
    return whole_if_exact(in_degrees(std::asin(x)), sin_degrees, x);
}
double acos_degrees(double x) {
    return whole_if_exact(in_degrees(std::acos(x)), cos_degrees, x);
}
double atan_degrees(double x) {
    return whole_if_exact(in_degrees(std::atan(x)), tan_degrees, x);
}
double atan2_degrees(double y, double x) {
    const double degrees = in_degrees(std::atan2(y, x));
    const double whole = std::round(degrees);
    return std::abs(degrees - whole) < 3e-14 ? whole : degrees;
}

}  // namespace csg
