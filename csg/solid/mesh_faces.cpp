#include "csg/solid/mesh_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "csg/solid/no_index.h"

namespace csg::solid {
namespace {

constexpr double kFlatDegrees = 0.05;  // Degrees.
constexpr double kLeastHeight = 1e-9;  // Of the box's diagonal: of triangles whose plane is known.

/// A triangle's edge, among those that have the same lesser point.
struct HalfEdge {
    std::uint32_t other = 0;  ///< The greater point.
    std::uint32_t triangle = 0;
    bool up = false;  ///< From the lesser point.
};

glm::dvec3 normal_of(const Solid& solid, std::uint32_t triangle) {
    const glm::uvec3& t = solid.triangles[triangle];
    const glm::dvec3 &a = solid.points[t.x], &b = solid.points[t.y], &c = solid.points[t.z];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double area = glm::length(n);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    return area > kLeastHeight * solid.box.diagonal() * longest ? n / area : glm::dvec3(0.0);
}

glm::dvec3 middle_of(const Solid& solid, std::uint32_t triangle) {
    const glm::uvec3& t = solid.triangles[triangle];
    return (solid.points[t.x] + solid.points[t.y] + solid.points[t.z]) / 3.0;
}

}  // namespace

Sets::Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t Sets::find(std::uint32_t i) {
    while (parent_[i] != i) {
        i = parent_[i] = parent_[parent_[i]];
    }
    return i;
}

void Sets::unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

std::vector<std::uint32_t> Sets::numbers(std::uint32_t& count) {
    std::vector<std::uint32_t> numbers(parent_.size());
    count = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
        // The least of a set stands for it.
        const std::uint32_t root = find(i);
        numbers[i] = root == i ? count++ : numbers[root];
    }
    return numbers;
}

MeshFaces::MeshFaces(const Solid& solid) {
    find_edges(solid);
    unite_flat(solid);
    sort_around();
}

void MeshFaces::find_edges(const Solid& solid) {
    // Sorted by lesser points; there are few to each.
    std::vector<std::uint32_t> first(solid.points.size() + 1);
    for (const glm::uvec3& t : solid.triangles) {
        for (int i = 0; i < 3; ++i) {
            ++first[std::min(t[i], t[(i + 1) % 3]) + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<HalfEdge> halves(3 * solid.triangles.size());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t k = 0; k < solid.triangles.size(); ++k) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = solid.triangles[k][i], b = solid.triangles[k][(i + 1) % 3];
            halves[next[std::min(a, b)]++] = {std::max(a, b), k, a < b};
        }
    }
    edges_.reserve(halves.size() / 2);
    for (std::uint32_t point = 0; point + 1 < first.size(); ++point) {
        const auto begin = halves.begin() + first[point], end = halves.begin() + first[point + 1];
        std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
            return a.other != b.other ? a.other < b.other : a.triangle < b.triangle;
        });
        for (auto at = begin; at != end;) {
            const auto last = std::find_if(at, end, [&](const HalfEdge& h) { return h.other != at->other; });
            if (last - at == 2 && at[0].up != at[1].up) {
                const bool up = at[0].up;
                edges_.push_back({up ? point : at->other, up ? at->other : point, {at[0].triangle, at[1].triangle}, 0});
            }
            at = last;
        }
    }
}

void MeshFaces::unite_flat(const Solid& solid) {
    std::vector<glm::dvec3> normals;
    normals.reserve(solid.triangles.size());
    for (std::uint32_t i = 0; i < solid.triangles.size(); ++i) {
        normals.push_back(normal_of(solid, i));
    }
    Sets faces(solid.triangles.size());
    // A triangle of no area is of the face beyond its longest edge.
    std::vector<std::uint32_t> longest(solid.triangles.size(), kNone);
    std::vector<double> length(solid.triangles.size());
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        MeshEdge& edge = edges_[i];
        const glm::dvec3 &m = normals[edge.triangles[0]], &n = normals[edge.triangles[1]];
        if (m == glm::dvec3(0.0) || n == glm::dvec3(0.0)) {
            const double own = glm::length(solid.points[edge.to] - solid.points[edge.from]);
            for (const std::uint32_t t : edge.triangles) {
                if (normals[t] == glm::dvec3(0.0) && own > length[t]) {
                    length[t] = own;
                    longest[t] = i;
                }
            }
            continue;
        }
        const double angle = std::atan2(glm::length(glm::cross(m, n)), glm::dot(m, n)) * (180 / std::numbers::pi);
        if (angle <= kFlatDegrees) {
            faces.unite(edge.triangles[0], edge.triangles[1]);
            continue;
        }
        const glm::dvec3 beyond = middle_of(solid, edge.triangles[1]) - solid.points[edge.from];
        edge.degrees = static_cast<float>(glm::dot(m, beyond) > 0 ? -angle : angle);
    }
    for (std::uint32_t t = 0; t < longest.size(); ++t) {
        if (longest[t] != kNone) {
            faces.unite(edges_[longest[t]].triangles[0], edges_[longest[t]].triangles[1]);
        }
    }
    face_of_ = faces.numbers(count_);
    std::erase_if(edges_, [&](const MeshEdge& edge) { return side(edge, 0) == side(edge, 1); });
}

void MeshFaces::sort_around() {
    first_.assign(count_ + 1, 0);
    for (const MeshEdge& edge : edges_) {
        ++first_[side(edge, 0) + 1];
        ++first_[side(edge, 1) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    around_.resize(2 * edges_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        around_[next[side(edges_[i], 0)]++] = i;
        around_[next[side(edges_[i], 1)]++] = i;
    }
}

}  // namespace csg::solid
