#include "csg/solid/orientation.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <tuple>
#include <vector>

namespace csg::solid {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double kApart = 4;           // Units of the grid: edges nearer than this are not told apart.
constexpr std::size_t kMostTries = 8;  // Edges of a path that are looked from.

glm::dvec2 place(const ClipperLib::IntPoint& p) {
    return {static_cast<double>(p.X), static_cast<double>(p.Y)};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Paths that have a corner in common with another one, in ascending order.
std::vector<std::size_t> touching(const Paths& paths) {
    struct Corner {
        ClipperLib::cInt x, y;
        std::size_t path;
    };
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (const ClipperLib::IntPoint& p : paths[i])
            corners.push_back({p.X, p.Y, i});
    }
    std::sort(corners.begin(), corners.end(),
              [](const Corner& a, const Corner& b) { return std::tie(a.x, a.y, a.path) < std::tie(b.x, b.y, b.path); });
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Corner &a = corners[i - 1], &b = corners[i];
        if (a.x == b.x && a.y == b.y && a.path != b.path)
            found.insert(found.end(), {a.path, b.path});
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// Does the region lie to the left of the middle of an edge? Nothing where another edge is too near to tell.
std::optional<bool> is_left(const Paths& paths, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 middle = 0.5 * (from + to), along = glm::normalize(to - from), left(-along.y, along.x);
    bool inside = false;
    for (const Path& path : paths) {
        for (std::size_t i = 0; i < path.size(); ++i) {
            const glm::dvec2 a = place(path[i]) - middle, b = place(path[(i + 1) % path.size()]) - middle;
            const double x = glm::dot(along, a), y = glm::dot(along, b);
            if ((x < 0) == (y < 0))
                continue;
            const double height = cross(along, a) + (cross(along, b) - cross(along, a)) * (x / (x - y));
            const bool itself = a == from - middle && b == to - middle;
            if (!itself && std::abs(height) < kApart)
                return {};
            inside ^= !itself && height > 0;
        }
    }
    return inside;
}

/// Nothing where it cannot be told.
std::optional<bool> is_left(const Paths& paths, const Path& path) {
    std::vector<std::pair<double, std::size_t>> by_length;
    for (std::size_t i = 0; i < path.size(); ++i)
        by_length.emplace_back(-glm::distance(place(path[i]), place(path[(i + 1) % path.size()])), i);
    const auto most = static_cast<std::ptrdiff_t>(std::min(kMostTries, by_length.size()));
    std::partial_sort(by_length.begin(), by_length.begin() + most, by_length.end());
    by_length.resize(static_cast<std::size_t>(most));
    for (const auto& [length, i] : by_length) {
        if (const auto left = is_left(paths, place(path[i]), place(path[(i + 1) % path.size()])))
            return left;
    }
    return {};
}

}  // namespace

void orient(Paths& paths) {
    if (paths.size() < 2)
        return;
    for (const std::size_t i : touching(paths)) {
        if (!is_left(paths, paths[i]).value_or(true))
            std::reverse(paths[i].begin(), paths[i].end());
    }
}

}  // namespace csg::solid
