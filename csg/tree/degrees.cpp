#include "csg/tree/degrees.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace csg {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// Sine of 0 to 90 degrees.
double sin_first_quadrant(double x) {
    if (x == 30.0)
        return 0.5;
    if (x == 45.0)
        return std::numbers::sqrt2 / 2;
    if (x == 60.0)
        return std::numbers::sqrt3 / 2;
    if (x < 45.0)
        return std::sin(x * kRadians);
    // Measured from 90, so that sin(60) and cos(30) are one value.
    return std::cos((90.0 - x) * kRadians);
}

double round_if_near(double degrees) {
    // Whole degrees are what people start from. Near its ends an arc magnifies the rounding of its argument: acos is
    // off by 3e-13 at one degree.
    const double rounded = std::round(degrees);
    return rounded != 0.0 && std::abs(degrees - rounded) < 4e-13 ? rounded : degrees;
}

}  // namespace

double sin_degrees(double degrees) {
    if (!std::isfinite(degrees))
        return std::numeric_limits<double>::quiet_NaN();
    double x = std::fmod(degrees, 360.0);  // exact
    bool negative = false;
    if (x < 0.0) {
        x = -x;
        negative = true;
    }
    if (x >= 180.0) {
        x -= 180.0;
        negative = !negative;
    }
    if (x > 90.0)
        x = 180.0 - x;
    const double s = sin_first_quadrant(x);
    return negative && s != 0.0 ? -s : s;
}

double cos_degrees(double degrees) {
    if (!std::isfinite(degrees))
        return std::numeric_limits<double>::quiet_NaN();
    double x = std::abs(std::fmod(degrees, 360.0));
    if (x > 180.0)
        x = 360.0 - x;
    if (x > 90.0)
        return -sin_degrees(x - 90.0) + 0.0;
    return sin_first_quadrant(90.0 - x);
}

double tan_degrees(double degrees) {
    const double x = std::fmod(degrees, 180.0);
    if (x == 45.0 || x == -135.0)
        return 1.0;
    if (x == -45.0 || x == 135.0)
        return -1.0;
    if (std::abs(x) == 30.0 || std::abs(x) == 150.0)
        return (x > 0.0) == (std::abs(x) < 90.0) ? std::numbers::sqrt3 / 3 : -std::numbers::sqrt3 / 3;
    if (std::abs(x) == 60.0 || std::abs(x) == 120.0)
        return (x > 0.0) == (std::abs(x) < 90.0) ? std::numbers::sqrt3 : -std::numbers::sqrt3;
    return sin_degrees(degrees) / cos_degrees(degrees);
}

double asin_degrees(double x) {
    return round_if_near(std::asin(x) / kRadians);
}
double acos_degrees(double x) {
    return round_if_near(std::acos(x) / kRadians);
}
double atan_degrees(double x) {
    return round_if_near(std::atan(x) / kRadians);
}
double atan2_degrees(double y, double x) {
    return round_if_near(std::atan2(y, x) / kRadians);
}

}  // namespace csg
