#include "csg/reference/projection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "csg/reference/mesh_boolean.h"

namespace csg::reference {
namespace {

using Key = std::pair<double, double>;

/// Chains directed edges end to end. Where several go on from a point, the sharpest left turn is taken, so that loops
/// touch but do not cross.
std::vector<std::vector<glm::dvec2>> chain(const std::vector<std::pair<glm::dvec2, glm::dvec2>>& edges) {
    std::map<Key, std::vector<std::size_t>> from;
    for (std::size_t i = 0; i < edges.size(); ++i)
        from[{edges[i].first.x, edges[i].first.y}].push_back(i);
    std::vector<char> used(edges.size(), 0);
    std::vector<std::vector<glm::dvec2>> loops;
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (used[start] != 0)
            continue;
        std::vector<glm::dvec2> loop;
        for (std::size_t at = start; used[at] == 0;) {
            used[at] = 1;
            loop.push_back(edges[at].first);
            const glm::dvec2 along = edges[at].second - edges[at].first;
            double best = -10;
            std::size_t next = at;
            for (const std::size_t i : from[{edges[at].second.x, edges[at].second.y}]) {
                if (used[i] != 0)
                    continue;
                const glm::dvec2 on = edges[i].second - edges[i].first;
                const double turn = std::atan2(along.x * on.y - along.y * on.x, glm::dot(along, on));
                if (turn > best) {
                    best = turn;
                    next = i;
                }
            }
            at = next;
        }
        if (loop.size() > 2)
            loops.push_back(std::move(loop));
    }
    return loops;
}

/// The directed edges that do not have their opposite.
Outlines outlines_of(const std::vector<std::pair<glm::dvec2, glm::dvec2>>& edges) {
    std::map<std::pair<Key, Key>, int> count;
    const auto key = [](const glm::dvec2& p) { return Key{p.x + 0.0, p.y + 0.0}; };
    for (const auto& [a, b] : edges) {
        ++count[{key(a), key(b)}];
        --count[{key(b), key(a)}];
    }
    std::vector<std::pair<glm::dvec2, glm::dvec2>> border;
    for (const auto& [edge, n] : count) {
        for (int i = 0; i < n; ++i)
            border.emplace_back(glm::dvec2(edge.first.first, edge.first.second),
                                glm::dvec2(edge.second.first, edge.second.second));
    }
    return {chain(border)};
}

Outlines section(const Mesh& mesh) {
    std::vector<std::pair<glm::dvec2, glm::dvec2>> edges;
    for (const glm::uvec3& t : mesh.triangles) {
        // Points in the plane count as above it: the section is that just below.
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 &a = mesh.points[t[k]], &b = mesh.points[t[(k + 1) % 3]], &c = mesh.points[t[(k + 2) % 3]];
            const bool above_a = a.z >= 0, above_b = b.z >= 0, above_c = c.z >= 0;
            if (above_a == above_b || above_a == above_c)
                continue;
            // `a` is alone on its side. Each edge is cut from its lower end, so that its two triangles agree.
            const auto cut = [](glm::dvec3 p, glm::dvec3 q) {
                if (p.z > q.z)
                    std::swap(p, q);
                return glm::dvec2(p + (q - p) * (-p.z / (q.z - p.z)));
            };
            const glm::dvec2 on_ab = cut(a, b), on_ac = cut(a, c);
            if (on_ab != on_ac)
                edges.emplace_back(above_a ? on_ab : on_ac, above_a ? on_ac : on_ab);
        }
    }
    return outlines_of(edges);
}

/// The shadow is the lower side of the union of the prisms that stand on the triangles facing up.
Outlines shadow(const Mesh& mesh) {
    std::vector<Mesh> operands;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec2 a(mesh.points[t.x]), b(mesh.points[t.y]), c(mesh.points[t.z]);
        if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0)
            continue;
        Mesh prism;
        for (const double z : {0.0, 1.0}) {
            for (const glm::dvec2& p : {a, b, c})
                prism.points.emplace_back(p, z);
        }
        prism.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
        operands.push_back(std::move(prism));
    }
    const Mesh prisms = combine(ExpressionKind::Union, operands).mesh;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> edges;
    for (const glm::uvec3& t : prisms.triangles) {
        if (prisms.points[t.x].z != 0 || prisms.points[t.y].z != 0 || prisms.points[t.z].z != 0)
            continue;
        // Seen from below: turned around.
        for (int k = 0; k < 3; ++k)
            edges.emplace_back(glm::dvec2(prisms.points[t[(k + 1) % 3]]), glm::dvec2(prisms.points[t[k]]));
    }
    return outlines_of(edges);
}

}  // namespace

double Outlines::area() const {
    double twice = 0;
    for (const auto& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            twice += a.x * b.y - a.y * b.x;
        }
    }
    return twice / 2;
}

Outlines projection(const Mesh& mesh, bool cut) {
    return cut ? section(mesh) : shadow(mesh);
}

}  // namespace csg::reference
