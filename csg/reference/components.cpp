#include "csg/reference/components.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "csg/reference/disjoint_sets.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

struct Edge {
    std::uint32_t low, high, triangle;
    bool forward;
    [[nodiscard]] bool same_ends(const Edge& other) const { return low == other.low && high == other.high; }
};

std::vector<Edge> sorted_edges(const Mesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& corners = mesh.triangles[t];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return edges;
}

std::vector<std::uint32_t> component_by_triangle(const Mesh& mesh) {
    const std::vector<Edge> edges = sorted_edges(mesh);
    DisjointSets sets(mesh.triangles.size());
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && edges[end].same_ends(edges[i])) {
            ++end;
        }
        if (end - i == 2) {
            sets.unite(edges[i].triangle, edges[i + 1].triangle);
        }
    }
    std::vector<std::uint32_t> component(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        component[t] = sets.find(t);
    }
    return component;
}

}  // namespace

std::vector<Mesh> components_of(const Mesh& mesh) {
    const std::vector<std::uint32_t> component = component_by_triangle(mesh);
    std::vector<std::uint32_t> triangles(component.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return component[a] < component[b]; });
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> index(mesh.points.size(), kNone), used;
    std::vector<Mesh> components;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == 0 || component[triangles[i]] != component[triangles[i - 1]]) {
            for (const std::uint32_t point : used) {
                index[point] = kNone;
            }
            used.clear();
            components.emplace_back();
        }
        Mesh& to = components.back();
        glm::uvec3 own;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t point = mesh.triangles[triangles[i]][k];
            if (index[point] == kNone) {
                index[point] = static_cast<std::uint32_t>(to.points.size());
                to.points.push_back(mesh.points[point]);
                used.push_back(point);
            }
            own[k] = index[point];
        }
        to.triangles.push_back(own);
        to.sources.push_back(mesh.sources.empty() ? 0 : mesh.sources[triangles[i]]);
    }
    return components;
}

Mesh welded(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
            std::span<const std::uint32_t> sources) {
    Mesh result;
    PointIds ids;
    std::vector<std::uint32_t> number;
    number.reserve(points.size());
    for (const glm::dvec3& p : points) {
        const auto [id, added] = ids.add(p);
        if (added) {
            result.points.push_back(p);
        }
        number.push_back(id);
    }
    result.triangles.reserve(triangles.size());
    result.sources.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const glm::uvec3& t = triangles[i];
        const glm::uvec3 own{number[t.x], number[t.y], number[t.z]};
        if (own.x == own.y || own.y == own.z || own.z == own.x) {
            continue;
        }
        result.triangles.push_back(own);
        result.sources.push_back(sources.empty() ? 0 : sources[i]);
    }
    return result;
}

bool balanced(const Mesh& mesh) {
    const std::vector<Edge> edges = sorted_edges(mesh);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        long balance = 0;
        for (; end < edges.size() && edges[end].same_ends(edges[i]); ++end) {
            balance += edges[end].forward ? 1 : -1;
        }
        if (balance != 0) {
            return false;
        }
    }
    return true;
}

glm::dvec3 before(const Mesh& mesh, double distance) {
    double largest = 0;
    glm::dvec3 point(0.0);
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 &p = mesh.points[t.x], &q = mesh.points[t.y], &r = mesh.points[t.z];
        const glm::dvec3 across = glm::cross(q - p, r - p);
        if (const double area = glm::length(across); area > largest) {
            largest = area;
            point = (p + q + r) / 3.0 + across * (distance / area);
        }
    }
    return point;
}

}  // namespace csg::reference
