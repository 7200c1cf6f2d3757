#include "csg/reference/minkowski.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/nef.h"
#include "csg/solid/plane_table.h"

namespace csg::reference {
namespace {

using Points = std::vector<glm::dvec3>;

/// The mesh's connected components.
std::vector<Mesh> components_of(const Mesh& mesh) {
    std::vector<std::uint32_t> root(mesh.points.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](std::uint32_t i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    for (const glm::uvec3& t : mesh.triangles) {
        root[find(t.x)] = find(t.y);
        root[find(t.y)] = find(t.z);
    }
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> component(mesh.points.size(), kNone), index(mesh.points.size(), kNone);
    std::vector<Mesh> components;
    for (const glm::uvec3& t : mesh.triangles) {
        std::uint32_t& c = component[find(t.x)];
        if (c == kNone) {
            c = static_cast<std::uint32_t>(components.size());
            components.emplace_back();
        }
        Mesh& to = components[c];
        glm::uvec3 own;
        for (int k = 0; k < 3; ++k) {
            if (index[t[k]] == kNone) {
                index[t[k]] = static_cast<std::uint32_t>(to.points.size());
                to.points.push_back(mesh.points[t[k]]);
            }
            own[k] = index[t[k]];
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

Mesh sum_of(const Mesh& a, const Mesh& b) {
    const std::vector<Points> left = convex_pieces_of(a), right = convex_pieces_of(b);
    std::vector<Mesh> hulls;
    for (const Points& p : left) {
        for (const Points& q : right) {
            Points sums;
            sums.reserve(p.size() * q.size());
            for (const glm::dvec3& x : p) {
                for (const glm::dvec3& y : q)
                    sums.push_back(x + y);
            }
            hulls.push_back(hull(sums));
        }
    }
    if (hulls.size() == 1)
        return std::move(hulls[0]);
    return combine(ExpressionKind::Union, hulls).mesh;
}

}  // namespace

Mesh minkowski_sum(std::span<const Mesh> operands) {
    Mesh sum;
    for (std::size_t i = 0; i < operands.size(); ++i)
        sum = i == 0 ? operands[0] : sum_of(sum, operands[i]);
    sum.sources.assign(sum.triangles.size(), 0);
    return sum;
}

}  // namespace csg::reference
