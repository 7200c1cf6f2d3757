#include "csg/reference/mesh.h"

#include <algorithm>
#include <utility>

#include "csg/reference/disjoint_sets.h"

namespace csg::reference {
namespace {

bool every_edge_has_its_opposite(const Mesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(mesh.triangles.size() * 3);
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            if (t[i] == t[(i + 1) % 3])
                return false;
            edges.emplace_back(t[i], t[(i + 1) % 3]);
        }
    }
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
        return false;
    return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
        return std::binary_search(edges.begin(), edges.end(), std::pair(e.second, e.first));
    });
}

}  // namespace

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
    for (std::uint32_t i = 0; i < used.size(); ++i)
        result.components += used[i] != 0 && sets.find(i) == i ? 1 : 0;
    // Seen from a point of each component: what is far from there cancels badly.
    const glm::dvec3 centre = result.box.empty() ? glm::dvec3(0.0) : result.box.centre();
    double volume6 = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 origin = result.components == 1 ? centre : mesh.points[sets.find(t.x)];
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

}  // namespace csg::reference
