#include "csg/reference/thin_pieces.h"

#include <algorithm>
#include <cmath>

#include "csg/reference/disjoint_sets.h"
#include "csg/solid/used_points.h"

namespace csg::reference {

namespace {

/// Of the largest coordinate.
constexpr double kThickness = 0x1p-46;
/// Volume over area to the power of 3/2; of a cube 0.07.
constexpr double kFlatness = 1e-3;

struct Piece {
    glm::dvec3 origin{0.0};
    bool seen = false;
    double volume = 0, area = 0, largest = 0;

    /// Of a flake half the area is one of its sides.
    [[nodiscard]] bool flake() const {
        const double size = std::abs(volume);
        return size <= kThickness * largest * 0.5 * area && size <= kFlatness * area * std::sqrt(area);
    }
};

}  // namespace

void drop_thin_pieces(Mesh& mesh) {
    DisjointSets sets(mesh.points.size());
    for (const glm::uvec3& t : mesh.triangles) {
        sets.unite(t.x, t.y);
        sets.unite(t.y, t.z);
    }
    std::vector<Piece> pieces(mesh.points.size());
    for (const glm::uvec3& t : mesh.triangles) {
        Piece& piece = pieces[sets.find(t.x)];
        if (!piece.seen) {
            piece.origin = mesh.points[t.x];
        }
        piece.seen = true;
        const glm::dvec3 a = mesh.points[t.x] - piece.origin, b = mesh.points[t.y] - piece.origin,
                         c = mesh.points[t.z] - piece.origin;
        piece.volume += glm::dot(a, glm::cross(b, c)) / 6;
        piece.area += 0.5 * glm::length(glm::cross(b - a, c - a));
        const glm::dvec3 most = glm::abs(mesh.points[t.x]);
        piece.largest = std::max({piece.largest, most.x, most.y, most.z});
    }
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (pieces[sets.find(mesh.triangles[t].x)].flake()) {
            continue;
        }
        mesh.triangles[count] = mesh.triangles[t];
        mesh.sources[count++] = mesh.sources[t];
    }
    if (count == mesh.triangles.size()) {
        return;
    }
    mesh.triangles.resize(count);
    mesh.sources.resize(count);
    mesh.points = solid::used_points(mesh.points, mesh.triangles);
}

}  // namespace csg::reference
