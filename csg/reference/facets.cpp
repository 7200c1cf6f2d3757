#include "csg/reference/facets.h"

#include <algorithm>
#include <cmath>

#include "csg/reference/face_planes.h"

namespace csg::reference {
namespace {

/// How far a corner may be off being convex, of the largest coordinate: rounding.
constexpr double kBent = 0x1p-44;

/// Polygons as rings of directed edges; edge 3 t + k runs from corner k of triangle t.
class Merger {
  public:
    explicit Merger(const Mesh& mesh) : mesh_(mesh), twins_(twins_of(mesh.triangles)) {
        const double largest = largest_coordinate(mesh.points);
        bent_ = kBent * largest;
        solid::PlaneTable table(solid::coincidence_tolerance(largest));
        planes_ = face_planes(mesh.points, mesh.triangles, table);
        for (const solid::PlaneRef& plane : planes_) {
            normals_.push_back(table.planes()[plane.index].normal * (plane.flipped ? -1.0 : 1.0));
        }
        const auto count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
        for (std::uint32_t e = 0; e < count; ++e) {
            next_.push_back(e - e % 3 + (e + 1) % 3);
            previous_.push_back(e - e % 3 + (e + 2) % 3);
        }
        removed_.assign(count, 0);
    }

    std::vector<std::vector<glm::dvec3>> merge() {
        for (const std::uint32_t edge : inner_edges()) {
            if (may_go(edge) && may_go(twins_[edge])) {
                remove(edge);
            }
        }
        std::vector<std::vector<glm::dvec3>> polygons;
        std::vector<char> seen(next_.size(), 0);
        for (std::uint32_t start = 0; start < next_.size(); ++start) {
            if (removed_[start] != 0 || seen[start] != 0) {
                continue;
            }
            std::vector<glm::dvec3>& polygon = polygons.emplace_back();
            for (std::uint32_t e = start; seen[e] == 0; e = next_[e]) {
                seen[e] = 1;
                // A corner where the ring goes straight on is none.
                if (glm::dot(turn(previous_[e], e), normals_[e / 3]) > bent_ * reach(previous_[e], e)) {
                    polygon.push_back(from(e));
                }
            }
            if (polygon.size() < 3) {
                polygons.pop_back();
            }
        }
        return polygons;
    }

  private:
    [[nodiscard]] const glm::dvec3& from(std::uint32_t edge) const {
        return mesh_.points[mesh_.triangles[edge / 3][static_cast<int>(edge % 3)]];
    }
    [[nodiscard]] glm::dvec3 along(std::uint32_t edge) const {
        const std::uint32_t corner = edge - edge % 3 + (edge + 1) % 3;
        return from(corner) - from(edge);
    }
    [[nodiscard]] glm::dvec3 turn(std::uint32_t in, std::uint32_t out) const {
        return glm::cross(along(in), along(out));
    }
    [[nodiscard]] double reach(std::uint32_t in, std::uint32_t out) const {
        return std::max(glm::length(along(in)), glm::length(along(out)));
    }

    /// Between triangles in one plane, the longest first.
    [[nodiscard]] std::vector<std::uint32_t> inner_edges() const {
        std::vector<std::uint32_t> edges;
        for (std::uint32_t e = 0; e < twins_.size(); ++e) {
            if (twins_[e] == kNoTwin || twins_[e] < e) {
                continue;
            }
            const solid::PlaneRef &p = planes_[e / 3], &q = planes_[twins_[e] / 3];
            if (p.index == q.index && p.flipped == q.flipped) {
                edges.push_back(e);
            }
        }
        std::stable_sort(edges.begin(), edges.end(),
                         [&](auto a, auto b) { return glm::dot(along(a), along(a)) > glm::dot(along(b), along(b)); });
        return edges;
    }

    /// Does the ring stay convex at the edge's beginning? Not where it would turn back: behind a corner at which it
    /// goes straight on, an edge may end that another polygon lies on both sides of.
    [[nodiscard]] bool may_go(std::uint32_t edge) const {
        const std::uint32_t in = previous_[edge], out = next_[twins_[edge]];
        const double bend = glm::dot(turn(in, out), normals_[edge / 3]), rounding = bent_ * reach(in, out);
        return bend > rounding || (bend >= -rounding && glm::dot(along(in), along(out)) > 0);
    }

    void remove(std::uint32_t edge) {
        const std::uint32_t twin = twins_[edge];
        const auto join = [&](std::uint32_t in, std::uint32_t out) {
            next_[in] = out;
            previous_[out] = in;
        };
        join(previous_[edge], next_[twin]);
        join(previous_[twin], next_[edge]);
        removed_[edge] = removed_[twin] = 1;
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> twins_, next_, previous_;
    std::vector<solid::PlaneRef> planes_;
    std::vector<glm::dvec3> normals_;  ///< By triangle.
    std::vector<char> removed_;
    double bent_ = 0;
};

}  // namespace

std::vector<std::vector<glm::dvec3>> convex_facets(const Mesh& mesh) {
    return Merger(mesh).merge();
}

}  // namespace csg::reference
