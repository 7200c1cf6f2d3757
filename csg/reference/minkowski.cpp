#include "csg/reference/minkowski.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "base/stop.h"
#include "csg/reference/disjoint_sets.h"
#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/nef.h"
#include "csg/solid/plane_table.h"

namespace csg::reference {
namespace {

using Points = std::vector<glm::dvec3>;

/// The triangles' component: across an edge of two triangles it goes on, across an edge where more meet it does not,
/// nor across a corner. So solids that only touch are apart.
std::vector<std::uint32_t> components_by_triangle(const Mesh& mesh) {
    struct Edge {
        std::uint32_t low, high, triangle;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& corners = mesh.triangles[t];
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
            edges.push_back({low, high, t});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    DisjointSets sets(mesh.triangles.size());
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
            ++end;
        if (end - i == 2)
            sets.unite(edges[i].triangle, edges[i + 1].triangle);
    }
    std::vector<std::uint32_t> component(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        component[t] = sets.find(t);
    return component;
}

std::vector<Mesh> components_of(const Mesh& mesh) {
    const std::vector<std::uint32_t> component = components_by_triangle(mesh);
    std::vector<std::uint32_t> triangles(component.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return component[a] < component[b]; });
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> index(mesh.points.size(), kNone), used;
    std::vector<Mesh> components;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == 0 || component[triangles[i]] != component[triangles[i - 1]]) {
            for (const std::uint32_t point : used)
                index[point] = kNone;
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
    }
    return components;
}

/// Does the hull hold no more than the mesh and a skin as thick as what makes planes one?
bool convex_but_for_rounding(const Mesh& mesh, const MeshFacts& known) {
    const MeshFacts full = facts(hull(mesh.points));
    const glm::dvec3 largest = glm::max(glm::abs(known.box.lo), glm::abs(known.box.hi));
    const double skin = solid::coincidence_tolerance(std::max({largest.x, largest.y, largest.z}));
    return known.manifold && full.volume > 0 && full.volume - known.volume <= skin * full.area;
}

std::vector<Points> convex_pieces_of(const Mesh& mesh) {
    std::vector<Points> pieces;
    for (Mesh& component : components_of(mesh)) {
        if (!convex_but_for_rounding(component, facts(component)))
            return convex_decomposition(mesh);  // a cavity is a component, too
        pieces.push_back(std::move(component.points));
    }
    return pieces;
}

Mesh sum_of(const Mesh& a, const Mesh& b, const std::stop_token& stop) {
    const std::vector<Points> left = convex_pieces_of(a), right = convex_pieces_of(b);
    std::vector<Mesh> hulls;
    for (const Points& p : left) {
        for (const Points& q : right) {
            base::end_if_asked(stop);
            Points sums;
            sums.reserve(p.size() * q.size());
            for (const glm::dvec3& x : p) {
                for (const glm::dvec3& y : q)
                    sums.push_back(x + y);
            }
            hulls.push_back(hull(sums, stop));
        }
    }
    if (hulls.size() == 1)
        return std::move(hulls[0]);
    return combine(ExpressionKind::Union, hulls, stop).mesh;
}

}  // namespace

Mesh minkowski_sum(std::span<const Mesh> operands, const std::stop_token& stop) {
    Mesh sum;
    for (std::size_t i = 0; i < operands.size(); ++i)
        sum = i == 0 ? operands[0] : sum_of(sum, operands[i], stop);
    sum.sources.assign(sum.triangles.size(), 0);
    return sum;
}

}  // namespace csg::reference
