#include "tests/fuzz/ray_lengths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace fuzz {
namespace {

/// Where the ray at p meets a triangle; `side` is 1 where it leaves upwards what the triangle bounds.
struct Hit {
    double z, slope;
    int side;
};

/// Which side of the line through both points p is on, the same whichever of them comes first.
bool left_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec2& p) {
    const bool forward = std::tie(a.x, a.y) < std::tie(b.x, b.y);
    const glm::dvec3 &from = forward ? a : b, &to = forward ? b : a;
    return ((to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x) > 0) == forward;
}

std::optional<Hit> hit(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec2& p) {
    if (p.x < std::min({a.x, b.x, c.x}) || p.x > std::max({a.x, b.x, c.x}) || p.y < std::min({a.y, b.y, c.y}) ||
        p.y > std::max({a.y, b.y, c.y})) {
        return {};
    }
    const bool ab = left_of(a, b, p), bc = left_of(b, c, p), ca = left_of(c, a, p);
    if (ab != bc || bc != ca) {
        return {};
    }
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (normal.z == 0) {
        return {};
    }
    const double z = a.z - (normal.x * (p.x - a.x) + normal.y * (p.y - a.y)) / normal.z;
    return Hit{std::clamp(z, std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z})),
               glm::length(normal) / std::abs(normal.z), normal.z > 0 ? 1 : -1};
}

double distance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec2& p) {
    const glm::dvec2 from(a), way = glm::dvec2(b) - from;
    const double length = glm::dot(way, way);
    const double t = length > 0 ? std::clamp(glm::dot(p - from, way) / length, 0.0, 1.0) : 0.0;
    return glm::distance(p, from + t * way);
}

struct Crossing {
    double z;
    csg::LeafId leaf;
    int side;
};

/// The part from above to below.
double length_of(const csg::Scene& scene, std::vector<Crossing>& crossings, std::vector<int>& windings,
                 std::vector<char>& values) {
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.z > b.z; });
    std::fill(windings.begin(), windings.end(), 0);
    double length = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        windings[crossings[i].leaf] += crossings[i].side;
        const double way = crossings[i].z - crossings[i + 1].z;
        if (way > 0 && csg::evaluate(
                           scene, scene.parts[0], [&](csg::LeafId leaf) { return windings[leaf] != 0; }, values)) {
            length += way;
        }
    }
    return length;
}

}  // namespace

std::vector<RayLength> lengths_inside(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                                      const std::vector<glm::dvec2>& rays) {
    std::vector<RayLength> result(rays.size());
    for (RayLength& ray : result) {
        ray.nearest = std::numeric_limits<double>::infinity();
    }
    std::vector<std::vector<Crossing>> crossings(rays.size());
    std::vector<glm::dvec3> points;
    for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
        const csg::solid::Solid& solid = *geometry.leaves[leaf].solid;
        const glm::dmat4& matrix = scene.leaves[leaf].to_world;
        points.clear();
        for (const glm::dvec3& p : solid.points) {
            points.emplace_back(matrix * glm::dvec4(p, 1.0));
        }
        for (const glm::uvec3& t : solid.triangles) {
            const glm::dvec3 &a = points[t.x], &b = points[t.y], &c = points[t.z];
            for (std::size_t i = 0; i < rays.size(); ++i) {
                result[i].nearest = std::min(
                    {result[i].nearest, distance(a, b, rays[i]), distance(b, c, rays[i]), distance(c, a, rays[i])});
                if (const auto met = hit(a, b, c, rays[i])) {
                    crossings[i].push_back({met->z, leaf, met->side});
                    result[i].slopes += met->slope;
                }
            }
        }
    }
    std::vector<int> windings(scene.leaves.size());
    std::vector<char> values;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        result[i].length = length_of(scene, crossings[i], windings, values);
    }
    return result;
}

std::vector<RayLength> lengths_inside(const csg::reference::Mesh& mesh, const std::vector<glm::dvec2>& rays) {
    std::vector<RayLength> result(rays.size());
    for (const glm::uvec3& t : mesh.triangles) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (const auto met = hit(mesh.points[t.x], mesh.points[t.y], mesh.points[t.z], rays[i])) {
                result[i].length += met->side * met->z;
                result[i].slopes += met->slope;
            }
        }
    }
    return result;
}

}  // namespace fuzz
