#include "csg/solid/outline_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace csg::solid {
namespace {

constexpr double kFlat = 0.05;  // Degrees, of corners that are none.

/// Of angles that follow each other along a curve, the larger to the smaller: where an arc ends in its tangent, the
/// last angle is half as large as those before.
constexpr double kMostRatio = 2.3;

/// Of edges that follow each other along a curve whose angles are up to that; coarse curves are even ones.
double most_ratio_of_lengths(double degrees) {
    return degrees < 12 ? 6 : degrees < 25 ? 3 : 1.7;
}

/// A loop without the corners that lie on straight lines.
struct Bends {
    std::vector<std::size_t> corner;  ///< Of the loop.
    std::vector<double> angle;        ///< Degrees, positive to the left.
    std::vector<double> length;       ///< To the next.
};

std::vector<double> angles_of(const Loop& loop) {
    std::vector<double> angles(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2& at = loop[i];
        const glm::dvec2 in = at - loop[(i + loop.size() - 1) % loop.size()], out = loop[(i + 1) % loop.size()] - at;
        angles[i] = std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)) * (180 / std::numbers::pi);
    }
    return angles;
}

Bends bends_of(const Loop& loop, const std::vector<double>& angles) {
    Bends bends;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (std::abs(angles[i]) > kFlat) {
            bends.corner.push_back(i);
            bends.angle.push_back(angles[i]);
        }
    }
    for (std::size_t i = 0; i < bends.corner.size(); ++i) {
        bends.length.push_back(glm::length(loop[bends.corner[(i + 1) % bends.corner.size()]] - loop[bends.corner[i]]));
    }
    return bends;
}

bool alike(double a, double b) {
    const double least = std::min(std::abs(a), std::abs(b)), most = std::max(std::abs(a), std::abs(b));
    return a * b > 0 && most <= kMostBend && most <= kMostRatio * least;
}

/// By corner of the loop.
std::vector<char> smooth_corners(const Loop& loop, const std::vector<double>& angles) {
    std::vector<char> smooth(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        smooth[i] = std::abs(angles[i]) < kLeastCrease ? 1 : 0;
    }
    const Bends bends = bends_of(loop, angles);
    const std::size_t count = bends.corner.size();
    for (std::size_t i = 0; count > 3 && i < count; ++i) {
        const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
        if (!alike(bends.angle[before], bends.angle[i]) || !alike(bends.angle[i], bends.angle[after])) {
            continue;
        }
        const double a = bends.length[before], b = bends.length[i];
        const double most =
            std::max({std::abs(bends.angle[before]), std::abs(bends.angle[i]), std::abs(bends.angle[after])});
        if (std::max(a, b) <= most_ratio_of_lengths(most) * std::min(a, b)) {
            smooth[bends.corner[before]] = smooth[bends.corner[i]] = smooth[bends.corner[after]] = 1;
        }
    }
    return smooth;
}

/// The edges of one loop. `first`: the number of its first curve; gives how many there are.
std::uint32_t add_loop(const std::vector<double>& angles, const std::vector<char>& smooth, std::uint32_t first,
                       std::vector<FacetGroup>& edges) {
    const std::size_t count = angles.size();
    const auto corners = static_cast<std::size_t>(std::count(smooth.begin(), smooth.end(), 0));
    const auto begin = static_cast<std::size_t>(std::find(smooth.begin(), smooth.end(), 0) - smooth.begin()) % count;
    edges.resize(count);
    std::uint32_t curve = first;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = (begin + k) % count;
        if (k > 0 && smooth[i] == 0) {
            ++curve;
        }
        // One corner has the same curve on both sides.
        edges[i] = FacetGroup(curve, corners == 1 ? static_cast<std::uint32_t>(3 * k / count) : 0);
        if (smooth[i] != 0) {
            edges[i].bends(std::abs(angles[i]));
        }
        if (smooth[(i + 1) % count] != 0) {
            edges[i].bends(std::abs(angles[(i + 1) % count]));
        }
    }
    return curve + 1 - first;
}

}  // namespace

OutlineCurves curves_of(const Outline& outline) {
    OutlineCurves curves;
    for (const Loop& loop : outline.loops) {
        const std::vector<double> angles = angles_of(loop);
        curves.count += add_loop(angles, smooth_corners(loop, angles), curves.count, curves.edges.emplace_back());
    }
    return curves;
}

OutlineCurves curves_of(const Outline& outline, const Outline& divided) {
    const OutlineCurves whole = curves_of(outline);
    OutlineCurves curves;
    curves.count = whole.count;
    for (std::size_t l = 0; l < divided.loops.size(); ++l) {
        const Loop &from = outline.loops[l], &loop = divided.loops[l];
        std::vector<FacetGroup>& edges = curves.edges.emplace_back();
        std::size_t edge = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (edge + 1 < from.size() && loop[i] == from[edge + 1]) {
                ++edge;
            }
            edges.push_back(whole.edges[l][edge]);
        }
    }
    return curves;
}

}  // namespace csg::solid
