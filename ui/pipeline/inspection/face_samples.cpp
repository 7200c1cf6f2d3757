#include "ui/pipeline/inspection/face_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ui {

namespace {

/// From 0.3 to 0.7, by the seed: fractions of multiples of the golden ratio.
double share(std::uint32_t seed, double ratio) {
    const double turned = (seed + 1.0) * ratio;
    return 0.3 + 0.4 * (turned - std::floor(turned));
}

constexpr double kGolden = 0.6180339887498949, kPlastic = 0.7548776662466927;

}  // namespace

void clip(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const csg::Box& box,
          std::vector<glm::dvec3>& corners) {
    corners.clear();
    std::vector<glm::dvec3> polygon{a, b, c}, kept;
    for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const double wall = sign > 0 ? box.hi[axis] : -box.lo[axis];
            kept.clear();
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
                const double from = sign * p[axis] - wall, to = sign * q[axis] - wall;
                if (from <= 0) {
                    kept.push_back(p);
                }
                if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
                    kept.push_back(p + from / (from - to) * (q - p));
                }
            }
            std::swap(polygon, kept);
        }
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        corners.insert(corners.end(), {polygon[0], polygon[i - 1], polygon[i]});
    }
}

void sample_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double spacing, std::uint32_t seed,
                     std::vector<glm::dvec3>& points) {
    // The longest side lies below: what is above it becomes narrower row by row.
    std::array<glm::dvec3, 3> p{a, b, c};
    const auto side = [&](std::size_t i) { return glm::length(p[(i + 1) % 3] - p[i]); };
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        longest = side(i) > side(longest) ? i : longest;
    }
    std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(longest), p.end());
    const double length = glm::length(p[1] - p[0]);
    if (!(length > 0)) {
        return;
    }
    const glm::dvec3 u = (p[1] - p[0]) / length;
    const double apex = glm::dot(p[2] - p[0], u);
    const glm::dvec3 up = p[2] - p[0] - apex * u;
    const double height = glm::length(up);
    if (!(height > 1e-9 * length)) {
        return;
    }
    const glm::dvec3 v = up / height;
    const auto cells = [&](double extent) { return std::max(1.0, std::ceil(extent / spacing)); };
    const double rows = cells(height);
    for (double row = 0; row < rows; ++row) {
        const double below = row * height / rows, above = below + height / rows;
        const double lo = below / height * apex, hi = length - below / height * (length - apex);
        const double columns = cells(hi - lo);
        for (double column = 0; column < columns; ++column, ++seed) {
            const double x = lo + (column + share(seed, kGolden)) * (hi - lo) / columns;
            const double left = apex > 0 ? x * height / apex : height;
            const double right = apex < length ? (length - x) * height / (length - apex) : height;
            const double top = std::min({above, left, right});
            const double y = below + share(seed, kPlastic) * std::max(0.0, top - below);
            points.push_back(p[0] + x * u + y * v);
        }
    }
}

}  // namespace ui
