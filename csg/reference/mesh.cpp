#include "csg/reference/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "csg/reference/disjoint_sets.h"

namespace csg::reference {
namespace {

/// Edges are put beside those that begin at the same point, so nothing large is sorted.
bool every_edge_has_its_opposite(const Mesh& mesh) {
    std::vector<std::uint32_t> first(mesh.points.size() + 1, 0), ends(3 * mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            if (t[i] == t[(i + 1) % 3]) {
                return false;
            }
            ++first[t[i] + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            ends[next[t[i]]++] = t[(i + 1) % 3];
        }
    }
    const auto at = [&](std::uint32_t point) { return ends.begin() + first[point]; };
    for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
        std::sort(at(p), at(p + 1));
        if (std::adjacent_find(at(p), at(p + 1)) != at(p + 1)) {
            return false;
        }
    }
    for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
        if (!std::all_of(at(p), at(p + 1), [&](std::uint32_t q) { return std::binary_search(at(q), at(q + 1), p); })) {
            return false;
        }
    }
    return true;
}

}  // namespace

double largest_coordinate(std::span<const glm::dvec3> points) {
    double largest = 0;
    for (const glm::dvec3& p : points) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return largest;
}

double largest_coordinate(std::span<const Mesh> meshes) {
    double largest = 0;
    for (const Mesh& mesh : meshes) {
        largest = std::max(largest, largest_coordinate(mesh.points));
    }
    return largest;
}

MeshFacts facts(const Mesh& mesh) {
    MeshFacts result;
    DisjointSets sets(mesh.points.size());
    std::vector<char> used(mesh.points.size(), 0);
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            result.box = enclose(result.box, mesh.points[t[i]]);
            used[t[i]] = 1;
            sets.unite(t[i], t[(i + 1) % 3]);
        }
    }
    const auto count = static_cast<long>(std::count(used.begin(), used.end(), 1));
    for (std::uint32_t i = 0; i < used.size(); ++i) {
        result.components += used[i] != 0 && sets.find(i) == i ? 1 : 0;
    }
    // Seen from a point of each component: what is far from there cancels badly.
    const glm::dvec3 center = result.box.empty() ? glm::dvec3(0.0) : result.box.center();
    double volume6 = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 origin = result.components == 1 ? center : mesh.points[sets.find(t.x)];
        const glm::dvec3 a = mesh.points[t.x] - origin, b = mesh.points[t.y] - origin, c = mesh.points[t.z] - origin;
        volume6 += glm::dot(a, glm::cross(b, c));
        result.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    result.volume = volume6 / 6;
    result.manifold = every_edge_has_its_opposite(mesh);
    // Euler: points − edges + triangles = 2 (components − genus), and there are 3/2 as many edges as triangles.
    const long euler = count - static_cast<long>(mesh.triangles.size()) / 2;
    result.genus = static_cast<long>(result.components) - euler / 2;
    return result;
}

MeshFacts both(const MeshFacts& a, const MeshFacts& b) {
    return {enclose(a.box, b.box),       a.area + b.area,   a.volume + b.volume,
            a.components + b.components, a.genus + b.genus, a.manifold && b.manifold};
}

}  // namespace csg::reference
