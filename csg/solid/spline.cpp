#include "csg/solid/spline.h"

#include <algorithm>

namespace csg::solid {
namespace {

constexpr int kHighestDegree = 15;

bool fits(const Spline& s) {
    if (s.degree < 1 || s.degree > kHighestDegree) {
        return false;
    }
    const auto degree = static_cast<std::size_t>(s.degree);
    return s.points.size() > degree && s.knots.size() == s.points.size() + degree + 1 &&
           std::is_sorted(s.knots.begin(), s.knots.end()) &&
           (s.weights.empty() || (s.weights.size() == s.points.size() &&
                                  std::all_of(s.weights.begin(), s.weights.end(), [](double w) { return w > 0; })));
}

/// At parameter t of the span that begins at knot `span`: affine combinations of the points that count there, in
/// homogeneous coordinates.
glm::dvec2 point_at(const Spline& s, std::size_t span, double t) {
    const auto degree = static_cast<std::size_t>(s.degree);
    std::vector<glm::dvec3> p(degree + 1);
    for (std::size_t i = 0; i <= degree; ++i) {
        const std::size_t at = span - degree + i;
        const double weight = s.weights.empty() ? 1 : s.weights[at];
        p[i] = {s.points[at] * weight, weight};
    }
    for (std::size_t round = 1; round <= degree; ++round) {
        for (std::size_t i = degree; i >= round; --i) {
            const double from = s.knots[span - degree + i], to = s.knots[span + 1 + i - round];
            const double part = to > from ? (t - from) / (to - from) : 0;
            p[i] = (1 - part) * p[i - 1] + part * p[i];
        }
    }
    return glm::dvec2(p[degree]) / p[degree].z;
}

}  // namespace

std::optional<Loop> points_along(const Spline& spline, int steps) {
    if (!fits(spline)) {
        return std::nullopt;
    }
    Loop result;
    const auto degree = static_cast<std::size_t>(spline.degree);
    for (std::size_t span = degree; span < spline.points.size(); ++span) {
        const double from = spline.knots[span], to = spline.knots[span + 1];
        if (!(to > from)) {
            continue;
        }
        if (result.empty()) {
            result.push_back(point_at(spline, span, from));
        }
        for (int i = 1; i <= steps; ++i) {
            result.push_back(point_at(spline, span, from + (to - from) * i / steps));
        }
    }
    if (result.empty()) {
        return std::nullopt;
    }
    return result;
}

}  // namespace csg::solid
