#include "csg/solid/triangulate.h"

#include <numeric>

#include "csg/solid/bent_face.h"
#include "csg/solid/ear_cutting.h"
#include "csg/solid/indexed_outline.h"
#include "csg/solid/sweep_triangulation.h"

namespace csg::solid {
namespace {

glm::dvec3 newell_normal(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3& a = points[face[i]];
        const glm::dvec3& b = points[face[(i + 1) % face.size()]];
        normal += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    return normal;
}

/// Drops the axis along which the face is seen best; keeps the orientation counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                                const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<glm::dvec2> flat;
    flat.reserve(face.size());
    for (const std::uint32_t index : face) {
        const glm::dvec3& p = points[index];
        flat.push_back(normal[axis] < 0 ? glm::dvec2(p[v], p[u]) : glm::dvec2(p[u], p[v]));
    }
    return flat;
}

/// Turns left everywhere and goes around once.
bool is_convex(const std::vector<glm::dvec2>& loop) {
    const std::size_t n = loop.size();
    int changes_of_direction = 0;
    double last = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % n], &c = loop[(i + 2) % n];
        if (turn(a, b, c) < 0) {
            return false;
        }
        const double direction = b.x != a.x ? b.x - a.x : b.y - a.y;
        if (direction * last < 0) {
            ++changes_of_direction;
        }
        if (direction != 0) {
            last = direction;
        }
    }
    return changes_of_direction <= 2;
}

}  // namespace

void triangulate_convex(std::span<const std::uint32_t> face, std::vector<glm::uvec3>& triangles) {
    // Level by level, every other corner is cut off: few thin triangles, and the widest come first after reversal.
    std::vector<std::uint32_t> loop(face.begin(), face.end()), rest;
    std::vector<glm::uvec3> cut;
    while (loop.size() > 3) {
        rest.clear();
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; i += 2) {
            rest.push_back(loop[i]);
            if (i + 1 < n && (n > 3)) {
                cut.emplace_back(loop[i], loop[i + 1], loop[(i + 2) % n]);
            }
        }
        loop.swap(rest);
    }
    if (loop.size() == 3) {
        cut.emplace_back(loop[0], loop[1], loop[2]);
    }
    triangles.insert(triangles.end(), cut.rbegin(), cut.rend());
}

void triangulate(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                 std::vector<glm::uvec3>& triangles) {
    if (face.size() < 3) {
        return;
    }
    if (face.size() == 3) {
        triangles.emplace_back(face[0], face[1], face[2]);
        return;
    }
    if (triangulate_bent(points, face, triangles)) {
        return;
    }
    const std::vector<glm::dvec2> loop = project(points, face, newell_normal(points, face));
    if (is_convex(loop)) {
        triangulate_convex(face, triangles);
        return;
    }
    std::vector<std::uint32_t> around(loop.size());
    std::iota(around.begin(), around.end(), 0u);
    if (const auto swept = triangulate_by_sweep(exact_points(loop), std::span(&around, 1))) {
        for (const glm::uvec3& t : *swept) {
            triangles.emplace_back(face[t.x], face[t.y], face[t.z]);
        }
        return;
    }
    Ring ring;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        ring.push_back({loop[i], face[i]});
    }
    cut_ears(ring, triangles);
}

}  // namespace csg::solid
