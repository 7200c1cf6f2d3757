#include "csg/reference/convolution.h"

#include <array>
#include <cstddef>
#include <unordered_map>

#include "base/stop.h"
#include "csg/reference/face_planes.h"

namespace csg::reference {
namespace {

/// Far above the rounding of normals, far below what moves a face by the tolerance of planes.
constexpr double kTurned = 0x1p-35;
/// Parallelograms thinner than this, of their edges' lengths, are lines.
constexpr double kFlat = 0x1p-32;
constexpr double kMostPairs = 0x1p32;

/// Triangles with the normals of their planes.
struct Faces {
    explicit Faces(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& triangles) {
        solid::PlaneTable table(solid::coincidence_tolerance(largest_coordinate(points)));
        planes = face_planes(points, triangles, table);
        for (const solid::PlaneRef& plane : planes) {
            normals.push_back(table.planes()[plane.index].normal * (plane.flipped ? -1.0 : 1.0));
        }
        twins = twins_of(triangles);
    }
    [[nodiscard]] bool flat(std::uint32_t s, std::uint32_t t) const {
        return planes[s].index == planes[t].index && planes[s].flipped == planes[t].flipped;
    }
    std::vector<solid::PlaneRef> planes;
    std::vector<glm::dvec3> normals;
    std::vector<std::uint32_t> twins;
};

class Convolver {
  public:
    Convolver(const Mesh& a, const Convex& b, const std::stop_token& stop)
        : a_(a), b_(b), stop_(stop), of_a_(a.points, a.triangles), of_b_(b.points(), b.triangles()) {
        for (glm::dvec3& normal : of_b_.normals) {
            normal = turned(normal, kTurned);
        }
        for (std::uint32_t e = 0; e < of_b_.twins.size(); ++e) {
            const std::uint32_t twin = of_b_.twins[e];
            if (twin != kNoTwin && e < twin && !of_b_.flat(e / 3, twin / 3)) {
                edges_of_b_.push_back(e);
            }
        }
    }

    [[nodiscard]] bool closed() const {
        for (const auto* twins : {&of_a_.twins, &of_b_.twins}) {
            for (const std::uint32_t twin : *twins) {
                if (twin == kNoTwin) {
                    return false;
                }
            }
        }
        const double pairs = static_cast<double>(a_.triangles.size()) * static_cast<double>(b_.triangles().size());
        return pairs <= kMostPairs;
    }

    Mesh make() {
        faces_of_a();
        faces_of_b();
        parallelograms();
        sum_.sources.assign(sum_.triangles.size(), 0);
        return std::move(sum_);
    }

  private:
    static glm::dvec3 turned(const glm::dvec3& v, double by) {
        return v + by * glm::cross(glm::dvec3(0.612, 0.489, -0.622), v);
    }
    static std::uint32_t after(std::uint32_t edge) { return edge - edge % 3 + (edge + 1) % 3; }
    [[nodiscard]] static std::uint32_t from(const std::vector<glm::uvec3>& triangles, std::uint32_t edge) {
        return triangles[edge / 3][static_cast<int>(edge % 3)];
    }

    std::uint32_t point(std::uint32_t a, std::uint32_t b) {
        const auto [at, added] = ids_.try_emplace(std::uint64_t{a} << 32 | b, sum_.points.size());
        if (added) {
            sum_.points.push_back(a_.points[a] + b_.points()[b]);
        }
        return at->second;
    }

    void faces_of_a() {
        std::unordered_map<std::uint64_t, std::uint32_t> farthest;  // by plane and side
        for (std::uint32_t t = 0; t < a_.triangles.size(); ++t) {
            base::end_if_asked(stop_);
            const std::uint64_t plane = std::uint64_t{of_a_.planes[t].index} << 1 | (of_a_.planes[t].flipped ? 1U : 0U);
            const auto [at, added] = farthest.try_emplace(plane, 0);
            if (added) {
                at->second = b_.farthest(turned(of_a_.normals[t], -kTurned), 0);
            }
            const glm::uvec3& corners = a_.triangles[t];
            sum_.triangles.emplace_back(point(corners.x, at->second), point(corners.y, at->second),
                                        point(corners.z, at->second));
        }
    }

    /// The triangles around each corner, one fan after another.
    void faces_of_b() {
        std::vector<char> seen(of_a_.twins.size(), 0);
        std::vector<glm::dvec3> spokes;
        for (std::uint32_t start = 0; start < seen.size(); ++start) {
            if (seen[start] != 0) {
                continue;
            }
            base::end_if_asked(stop_);
            const std::uint32_t corner = from(a_.triangles, start);
            spokes.clear();
            for (std::uint32_t e = start; seen[e] == 0; e = of_a_.twins[after(after(e))]) {
                seen[e] = 1;
                spokes.push_back(a_.points[from(a_.triangles, after(e))] - a_.points[corner]);
            }
            for (std::uint32_t t = 0; t < b_.triangles().size(); ++t) {
                if (farthest_along(of_b_.normals[t], spokes)) {
                    const glm::uvec3& corners = b_.triangles()[t];
                    sum_.triangles.emplace_back(point(corner, corners.x), point(corner, corners.y),
                                                point(corner, corners.z));
                }
            }
        }
    }

    /// Is the solid at a corner, whose edges these are, counter-clockwise seen from outside, all behind it?
    static bool farthest_along(const glm::dvec3& normal, const std::vector<glm::dvec3>& spokes) {
        for (const glm::dvec3& spoke : spokes) {
            if (!(glm::dot(normal, spoke) < 0)) {
                return false;
            }
        }
        // The edges meet a plane behind the corner around the solid, or around what is outside.
        double area = 0;
        const auto met = [&](std::size_t i) { return spokes[i] / -glm::dot(normal, spokes[i]); };
        for (std::size_t i = 0; i < spokes.size(); ++i) {
            area += glm::dot(normal, glm::cross(met(i), met((i + 1) % spokes.size())));
        }
        return area > 0;
    }

    void parallelograms() {
        std::vector<double> above(b_.triangles().size());
        for (std::uint32_t e = 0; e < of_a_.twins.size(); ++e) {
            const std::uint32_t twin = of_a_.twins[e];
            if (twin < e || of_a_.flat(e / 3, twin / 3)) {
                continue;
            }
            base::end_if_asked(stop_);
            const std::uint32_t from_a = from(a_.triangles, e), to_a = from(a_.triangles, after(e));
            const glm::dvec3 along = a_.points[to_a] - a_.points[from_a];
            const glm::dvec3 &left = of_a_.normals[e / 3], &right = of_a_.normals[twin / 3];
            if (!(glm::dot(glm::cross(right, left), along) < 0)) {
                continue;  // not convex
            }
            for (std::size_t t = 0; t < above.size(); ++t) {
                above[t] = glm::dot(of_b_.normals[t], along);
            }
            for (const std::uint32_t f : edges_of_b_) {
                const std::uint32_t s = f / 3, t = of_b_.twins[f] / 3;
                if ((above[s] < 0) != (above[t] < 0)) {
                    add_parallelogram(from_a, to_a, along, left, right, f);
                }
            }
        }
    }

    void add_parallelogram(std::uint32_t from_a, std::uint32_t to_a, const glm::dvec3& along, const glm::dvec3& left,
                           const glm::dvec3& right, std::uint32_t f) {
        const std::uint32_t from_b = from(b_.triangles(), f), to_b = from(b_.triangles(), after(f));
        const glm::dvec3 edge = b_.points()[to_b] - b_.points()[from_b], known = turned(edge, kTurned);
        if ((glm::dot(known, left) < 0) == (glm::dot(known, right) < 0)) {
            return;
        }
        const glm::dvec3 normal = glm::cross(along, known);
        const bool forward = glm::dot(normal, left + right) > 0;
        if (forward != (glm::dot(normal, of_b_.normals[f / 3] + of_b_.normals[of_b_.twins[f] / 3]) > 0)) {
            return;
        }
        if (glm::length(glm::cross(along, edge)) <= kFlat * glm::length(along) * glm::length(edge)) {
            return;
        }
        const std::uint32_t p = point(from_a, from_b), r = point(to_a, to_b);
        std::uint32_t q = point(to_a, from_b), s = point(from_a, to_b);
        if (!forward) {
            std::swap(q, s);
        }
        sum_.triangles.emplace_back(p, q, r);
        sum_.triangles.emplace_back(p, r, s);
    }

    const Mesh& a_;
    const Convex& b_;
    const std::stop_token& stop_;
    Faces of_a_, of_b_;
    std::vector<std::uint32_t> edges_of_b_;
    std::unordered_map<std::uint64_t, std::uint32_t> ids_;  ///< By point of a and point of b.
    Mesh sum_;
};

}  // namespace

std::optional<Mesh> convolution(const Mesh& a, const Convex& b, const std::stop_token& stop) {
    Convolver convolver(a, b, stop);
    if (!convolver.closed()) {
        return {};
    }
    return convolver.make();
}

}  // namespace csg::reference
