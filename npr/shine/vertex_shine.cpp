#include "npr/shine/vertex_shine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/parallel.h"
#include "npr/sorted/triangle_raster.h"

namespace npr {
namespace {

struct Edge {
    glm::dvec3 from, along;

    [[nodiscard]] double squared_distance(const glm::dvec3& p) const {
        const double length = glm::dot(along, along);
        const double at = length > 0 ? std::clamp(glm::dot(p - from, along) / length, 0.0, 1.0) : 0;
        const glm::dvec3 away = p - from - at * along;
        return glm::dot(away, away);
    }
};

/// One part's triangles: a range of the mesh's.
struct PartTriangles {
    std::uint32_t part = 0;
    std::size_t first = 0, end = 0;
};

std::vector<PartTriangles> triangles_of_parts(const ColoredMesh& mesh, std::span<const ShineSource> sources,
                                              std::size_t parts) {
    std::vector<char> wanted(parts, 0);
    for (const ShineSource& source : sources) {
        if (source.front >= 0) {
            wanted[(source.front_key >> 1U) - 1] = 1;
        }
    }
    std::vector<PartTriangles> result;
    for (std::size_t first = 0; first < mesh.parts.size();) {
        std::size_t end = first;
        while (end < mesh.parts.size() && mesh.parts[end] == mesh.parts[first]) {
            ++end;
        }
        if (mesh.parts[first] < parts && wanted[mesh.parts[first]] != 0) {
            result.push_back({mesh.parts[first], first, end});
        }
        first = end;
    }
    return result;
}

bool faces_eye(const ColoredMesh& mesh, std::size_t triangle, const base::View& view) {
    std::array<glm::dvec3, 3> eye;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& p = mesh.points[mesh.triangles[triangle][i]];
        eye[static_cast<std::size_t>(i)] = glm::dvec3(view.eye_from_world() * glm::dvec4(p, 1.0));
    }
    const glm::dvec3 normal = glm::cross(eye[1] - eye[0], eye[2] - eye[0]);
    return view.orthographic() ? normal.z > 0 : glm::dot(normal, eye[0]) < 0;
}

/// Edges between a triangle that faces the eye and one that does not.
std::vector<Edge> silhouettes(const ColoredMesh& mesh, const PartTriangles& of, const std::vector<char>& front) {
    std::unordered_map<std::uint64_t, char> first_side;
    std::vector<Edge> result;
    for (std::size_t t = of.first; t < of.end; ++t) {
        for (int i = 0; i < 3; ++i) {
            const glm::uint a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
            const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
            const auto [other, is_first] = first_side.try_emplace(key, front[t]);
            if (!is_first && other->second != front[t]) {
                result.push_back({mesh.points[a], mesh.points[b] - mesh.points[a]});
            }
        }
    }
    return result;
}

/// Of the part's points; others stay as they are.
void find_clearness(const ColoredMesh& mesh, const PartTriangles& of, const std::vector<Edge>& edges, double size,
                    float falloff, std::vector<float>& clearness) {
    std::vector<glm::uint> points;
    for (std::size_t t = of.first; t < of.end; ++t) {
        for (int i = 0; i < 3; ++i) {
            points.push_back(mesh.triangles[t][i]);
        }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    base::for_each_index(static_cast<int>(points.size()), [&] {
        return [&](int i) {
            const glm::uint point = points[static_cast<std::size_t>(i)];
            double nearest = std::numeric_limits<double>::infinity();
            for (const Edge& edge : edges) {
                nearest = std::min(nearest, edge.squared_distance(mesh.points[point]));
            }
            const double away = size > 0 ? std::min(std::sqrt(nearest) / size, 1.0) : 1.0;
            clearness[point] = away > 0 ? static_cast<float>(std::pow(away, static_cast<double>(falloff))) : 0.0F;
        };
    });
}

/// Shares of the corners in the point of the triangle that the sample (x, y) sees, as perspective has them.
glm::dvec3 shares(const std::array<RasterCorner, 3>& at, int x, int y) {
    const glm::dvec3 sample(x + 0.5, y + 0.5, 1.0);
    const glm::dvec3 share(glm::dot(sample, glm::cross(at[1], at[2])), glm::dot(sample, glm::cross(at[2], at[0])),
                           glm::dot(sample, glm::cross(at[0], at[1])));
    const double sum = share.x + share.y + share.z;
    return sum != 0 ? share / sum : glm::dvec3(1.0 / 3);
}

}  // namespace

std::vector<float> clearness_by_vertex(const ColoredMesh& mesh, const base::View& view,
                                       std::span<const layers::PartLook> parts, float falloff,
                                       std::span<const ShineSource> sources) {
    std::vector<float> of_points(mesh.points.size(), 0.0F), result(sources.size(), 0.0F);
    std::vector<double> nearest(sources.size(), std::numeric_limits<double>::infinity());
    std::vector<char> front(mesh.triangles.size(), 0);
    for (const PartTriangles& of : triangles_of_parts(mesh, sources, parts.size())) {
        for (std::size_t t = of.first; t < of.end; ++t) {
            front[t] = faces_eye(mesh, t, view) ? 1 : 0;
        }
        find_clearness(mesh, of, silhouettes(mesh, of, front), parts[of.part].radius, falloff, of_points);
        for (std::size_t t = of.first; t < of.end; ++t) {
            if (front[t] == 0) {
                continue;
            }
            std::array<glm::dvec3, 3> eye;
            std::array<RasterCorner, 3> at;
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3& p = mesh.points[mesh.triangles[t][static_cast<int>(i)]];
                eye[i] = glm::dvec3(view.eye_from_world() * glm::dvec4(p, 1.0));
                at[i] = raster_corner(view, eye[i]);
            }
            rasterize(view, eye, at, [&](int x, int y, double distance) {
                const std::size_t pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size().x) + static_cast<std::size_t>(x);
                if (sources[pixel].front < 0 || (sources[pixel].front_key >> 1U) - 1 != of.part ||
                    distance >= nearest[pixel]) {
                    return;
                }
                nearest[pixel] = distance;
                const glm::dvec3 share = shares(at, x, y);
                double clear = 0;
                for (int i = 0; i < 3; ++i) {
                    clear += share[i] * static_cast<double>(of_points[mesh.triangles[t][i]]);
                }
                result[pixel] = static_cast<float>(std::clamp(clear, 0.0, 1.0));
            });
        }
    }
    return result;
}

}  // namespace npr
