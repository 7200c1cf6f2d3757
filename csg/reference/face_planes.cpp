#include "csg/reference/face_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace csg::reference {

std::vector<std::uint32_t> twins_of(std::span<const glm::uvec3> triangles) {
    struct Edge {
        std::uint64_t ends;  ///< The lower first.
        std::uint32_t id;
        bool forward;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][static_cast<int>(k)], b = triangles[t][static_cast<int>((k + 1) % 3)];
            edges.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), 3 * t + k, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.ends != b.ends ? a.ends < b.ends : a.id < b.id; });
    std::vector<std::uint32_t> twins(edges.size(), kNoTwin);
    for (std::size_t i = 0, end; i < edges.size(); i = end) {
        for (end = i + 1; end < edges.size() && edges[end].ends == edges[i].ends; ++end) {
        }
        if (end - i == 2 && edges[i].forward != edges[i + 1].forward) {
            twins[edges[i].id] = edges[i + 1].id;
            twins[edges[i + 1].id] = edges[i].id;
        }
    }
    return twins;
}

std::vector<solid::PlaneRef> face_planes(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
                                         solid::PlaneTable& table) {
    struct Face {
        double area = 0, thickness = 0;
    };
    std::vector<Face> faces;
    faces.reserve(triangles.size());
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 u = points[t.y] - points[t.x], v = points[t.z] - points[t.x];
        const double area = glm::length(glm::cross(u, v));
        const double longest = std::max({glm::length(u), glm::length(v), glm::length(v - u)});
        faces.push_back({area, longest > 0 ? area / longest : 0});
    }
    std::vector<std::uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return faces[a].area > faces[b].area; });
    const bool any_thin =
        std::any_of(faces.begin(), faces.end(), [&](const Face& face) { return face.thickness <= table.tolerance(); });
    const std::vector<std::uint32_t> twins = any_thin ? twins_of(triangles) : std::vector<std::uint32_t>();
    std::vector<solid::PlaneRef> planes(triangles.size());
    std::vector<char> known(triangles.size(), 0);
    const auto of_neighbor = [&](std::uint32_t triangle) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t twin = twins[3 * triangle + k];
            if (twin == kNoTwin || known[twin / 3] == 0) {
                continue;
            }
            const solid::Plane& plane = table.planes()[planes[twin / 3].index];
            bool within = true;
            for (int i = 0; i < 3; ++i) {
                within &= std::abs(glm::dot(plane.normal, points[triangles[triangle][i]]) - plane.offset) <=
                          table.tolerance();
            }
            if (within) {
                planes[triangle] = planes[twin / 3];
                return true;
            }
        }
        return false;
    };
    for (const std::uint32_t triangle : order) {
        const glm::uvec3& t = triangles[triangle];
        if (faces[triangle].thickness > table.tolerance() || !of_neighbor(triangle)) {
            planes[triangle] = table.add(points[t.x], points[t.y], points[t.z]);
        }
        known[triangle] = 1;
    }
    return planes;
}

}  // namespace csg::reference
