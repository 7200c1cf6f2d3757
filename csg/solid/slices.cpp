#include "csg/solid/slices.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/smallest_radius.h"

namespace csg::solid {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::size_t whole(double slices) {
    return slices > 1 ? static_cast<std::size_t>(std::min(std::ceil(slices), kMostSlices)) : 1;  // 1 for NaN, too.
}

/// The longest of f(corner).
template <typename F>
double farthest(const Outline& outline, F&& f) {
    double result = 0;
    for (const Loop& loop : outline.loops) {
        for (const glm::dvec2& p : loop) {
            result = std::max(result, glm::length(f(p)));
        }
    }
    return result;
}

/// The length of the spiral r = a·angle from the center.
double spiral_length(double a, double angle) {
    return 0.5 * a * (angle * std::sqrt(1 + angle * angle) + std::asinh(angle));
}

/// Of the way of the outermost corner where it turns and is scaled alike in both directions.
double twisted_length(double radius, double twist, double height, double scale) {
    const double turn = twist * kPi / 180;
    if (scale == 1) {
        return std::hypot(radius * turn, height);
    }
    // Part of a spiral whose center lies beyond one of its ends.
    const double end = scale > 1 ? turn * scale / (scale - 1) : turn / (1 - scale);
    const double a = radius / end * (scale > 1 ? scale : 1.0);
    const double flat = spiral_length(a, end) - spiral_length(a, end - turn);
    return std::hypot(flat, height);
}

/// So many that no edge along a helix is further from it than `error`: half way along, one of angle a is at r cos(a /
/// 2) from the axis.
std::size_t slices_by_error(double radius, double twist, double error) {
    return error >= radius ? 1 : whole(twist * kPi / 180 / (2 * std::acos(1 - error / radius)));
}

std::size_t twist_slices(double radius, double twist, double height, double scale, const Fineness& f) {
    const std::size_t least = std::max<std::size_t>(1, whole(twist / 120));
    if (radius < kSmallestRadius || !std::isfinite(f.fn)) {
        return least;
    }
    if (f.fn > 0) {
        return std::max(whole(twist / 360 * f.fn), least);
    }
    if (f.fe > 0.0 && scale == 1) {
        return std::max(slices_by_error(radius, twist, *f.fe), least);
    }
    // As OpenSCAD, which ignores what is no number.
    return std::max(whole(std::fmin(twist / f.fa, twisted_length(radius, twist, height, scale) / f.fs)), least);
}

/// Corners that move straight but in different directions: walls are curved.
std::size_t scale_slices(double way, double height, const Fineness& f) {
    if (way < kSmallestRadius || !std::isfinite(f.fn)) {
        return 1;
    }
    return f.fn > 0 ? std::max<std::size_t>(1, static_cast<std::size_t>(std::min(f.fn, kMostSlices)))
                    : whole(std::hypot(way, height) / f.fs);
}

}  // namespace

std::size_t slice_count(const Outline& outline, const LinearExtrude& how) {
    if (how.slices) {
        return std::clamp<std::size_t>(*how.slices, 1, static_cast<std::size_t>(kMostSlices));
    }
    const double twist = std::abs(how.twist.value_or(0));
    const auto way = [&] { return farthest(outline, [&](const glm::dvec2& p) { return p - p * how.scale; }); };
    if (twist == 0) {
        return how.scale.x == how.scale.y ? 1 : scale_slices(way(), how.height, how.fineness);
    }
    const double radius = farthest(outline, [](const glm::dvec2& p) { return p; });
    if (how.scale.x == how.scale.y) {
        return twist_slices(radius, twist, how.height, how.scale.x, how.fineness);
    }
    return std::max(scale_slices(way(), how.height, how.fineness),
                    twist_slices(radius, twist, how.height, 1, how.fineness));
}

}  // namespace csg::solid
