#include "csg/solid/mesh_checks.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "csg/solid/winding_number.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostConvexityTests = std::size_t{1} << 24;

/// No point is outside any triangle's plane by more than rounding, and there are not several such shells in one.
bool is_convex(const Solid& solid) {
    if (solid.triangles.size() * solid.points.size() > kMostConvexityTests) {
        return false;
    }
    const double tolerance = solid.box.diagonal() * 1e-13;
    glm::dvec3 middle(0.0);
    for (const glm::uvec3& t : solid.triangles) {
        middle += solid.points[t.x] + solid.points[t.y] + solid.points[t.z];
    }
    middle /= 3.0 * static_cast<double>(solid.triangles.size());
    for (const glm::uvec3& t : solid.triangles) {
        const glm::dvec3 &a = solid.points[t.x], &b = solid.points[t.y], &c = solid.points[t.z];
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double length = glm::length(n);
        // The plane of a sliver says nothing.
        if (length <= tolerance * solid.box.diagonal()) {
            continue;
        }
        for (const glm::dvec3& p : solid.points) {
            if (glm::dot(n, p - a) > tolerance * length) {
                return false;
            }
        }
    }
    return winding_number(solid.points, solid.triangles, middle) == 1;
}

/// Is each directed edge there as often as its opposite?
bool is_closed(const Solid& solid) {
    /// An edge by its greater point, among those that have the same lesser one.
    struct Edge {
        std::uint32_t hi;
        int direction;
    };
    std::vector<std::uint32_t> first(solid.points.size() + 1);
    for (const glm::uvec3& t : solid.triangles) {
        for (int i = 0; i < 3; ++i) {
            ++first[std::min(t[i], t[(i + 1) % 3]) + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Edge> edges(solid.triangles.size() * 3);
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (const glm::uvec3& t : solid.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            edges[next[std::min(a, b)]++] = {std::max(a, b), a < b ? 1 : -1};
        }
    }
    for (std::size_t point = 0; point + 1 < first.size(); ++point) {
        std::sort(edges.begin() + first[point], edges.begin() + first[point + 1],
                  [](const Edge& a, const Edge& b) { return a.hi < b.hi; });
        for (std::size_t i = first[point]; i < first[point + 1];) {
            std::size_t j = i;
            int balance = 0;
            for (; j < first[point + 1] && edges[j].hi == edges[i].hi; ++j) {
                balance += edges[j].direction;
            }
            if (balance != 0) {
                return false;
            }
            i = j;
        }
    }
    return true;
}

}  // namespace

std::vector<std::uint32_t> first_of_equals(std::span<const glm::dvec3> points) {
    std::vector<std::uint32_t> order(points.size()), first(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        // Adding zero makes -0 and 0 one.
        return std::tuple(points[i].x + 0.0, points[i].y + 0.0, points[i].z + 0.0);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple_cat(key(a), std::tuple(a)) < std::tuple_cat(key(b), std::tuple(b));
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        first[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];
    }
    return first;
}

std::vector<std::uint32_t> first_of_near(std::span<const glm::dvec3> points, double distance) {
    std::vector<std::uint32_t> order(points.size()), first(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::iota(first.begin(), first.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(points[a].x, a) < std::tuple(points[b].x, b);
    });
    const auto root = [&](std::uint32_t i) {
        while (first[i] != i) {
            i = first[i] = first[first[i]];
        }
        return i;
    };
    for (std::size_t i = 0; i < order.size(); ++i) {
        const glm::dvec3& p = points[order[i]];
        // Points with the same x may be many; who has so many near each other has no gaps worth closing.
        constexpr std::size_t kMostNeighbors = 256;
        for (std::size_t j = i; j > 0 && i - j < kMostNeighbors; --j) {
            const glm::dvec3 way = glm::abs(points[order[j - 1]] - p);
            if (way.x > distance) {
                break;
            }
            if (way.y <= distance && way.z <= distance) {
                const std::uint32_t a = root(order[j - 1]), b = root(order[i]);
                first[std::max(a, b)] = std::min(a, b);
            }
        }
    }
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        first[i] = root(i);
    }
    return first;
}

void weld(std::vector<std::uint32_t>& face, std::span<const std::uint32_t> first) {
    for (std::uint32_t& index : face) {
        index = first[index];
    }
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) {
        face.pop_back();
    }
}

void check_mesh(Solid& solid) {
    solid.closed = is_closed(solid);
    solid.convex = solid.simple = solid.closed && is_convex(solid);
}

}  // namespace csg::solid
