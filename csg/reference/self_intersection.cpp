#include "csg/reference/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace csg::reference {
namespace {

class Triangle {
  public:
    explicit Triangle(const std::array<glm::dvec3, 3>& corners) : corners_(corners) {
        normal_ = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(normal_);
        normal_ = length > 0 ? normal_ / length : glm::dvec3(0.0);
        for (const glm::dvec3& p : corners)
            box_ = enclose(box_, p);
    }

    [[nodiscard]] const Box& box() const { return box_; }

    /// Does an edge of `other` pass through the inside, by more than the tolerance on both sides and at all edges?
    [[nodiscard]] bool pierced_by(const Triangle& other, double tolerance) const {
        if (normal_ == glm::dvec3(0.0))
            return false;
        std::array<double, 3> d;
        for (std::size_t i = 0; i < 3; ++i)
            d[i] = glm::dot(normal_, other.corners_[i] - corners_[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            if ((d[i] > tolerance && d[j] < -tolerance) || (d[i] < -tolerance && d[j] > tolerance)) {
                const glm::dvec3 at =
                    other.corners_[i] + (other.corners_[j] - other.corners_[i]) * (d[i] / (d[i] - d[j]));
                if (inside(at, tolerance))
                    return true;
            }
        }
        return false;
    }

    /// Do triangles of one plane overlap? Told by the axis that would separate them.
    [[nodiscard]] bool overlaps_in_plane(const Triangle& other, double tolerance) const {
        if (normal_ == glm::dvec3(0.0) || other.normal_ == glm::dvec3(0.0))
            return false;
        for (const glm::dvec3& p : other.corners_) {
            if (std::abs(glm::dot(normal_, p - corners_[0])) > tolerance)
                return false;
        }
        return !apart(*this, other, tolerance) && !apart(other, *this, tolerance);
    }

  private:
    [[nodiscard]] glm::dvec3 inward(std::size_t edge) const {
        return glm::normalize(glm::cross(normal_, corners_[(edge + 1) % 3] - corners_[edge]));
    }

    [[nodiscard]] bool inside(const glm::dvec3& p, double tolerance) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (glm::dot(inward(i), p - corners_[i]) <= tolerance)
                return false;
        }
        return true;
    }

    static bool apart(const Triangle& a, const Triangle& b, double tolerance) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 in = a.inward(i);
            if (std::all_of(b.corners_.begin(), b.corners_.end(),
                            [&](const glm::dvec3& p) { return glm::dot(in, p - a.corners_[i]) <= tolerance; }))
                return true;
        }
        return false;
    }

    std::array<glm::dvec3, 3> corners_;
    glm::dvec3 normal_;
    Box box_;
};

}  // namespace

std::size_t count_self_intersections(const Mesh& mesh, double tolerance) {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles)
        triangles.emplace_back(std::array{mesh.points[t.x], mesh.points[t.y], mesh.points[t.z]});
    const MeshFacts f = facts(mesh);
    const glm::dvec3 size = f.box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<std::uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return triangles[a].box().lo[axis] < triangles[b].box().lo[axis]; });
    std::vector<std::uint32_t> active;
    std::size_t count = 0;
    for (const std::uint32_t i : order) {
        const Triangle& t = triangles[i];
        std::erase_if(active, [&](auto j) { return triangles[j].box().hi[axis] < t.box().lo[axis]; });
        for (const std::uint32_t j : active) {
            const Triangle& u = triangles[j];
            if (!intersect(t.box(), u.box()).empty() &&
                (t.pierced_by(u, tolerance) || u.pierced_by(t, tolerance) || t.overlaps_in_plane(u, tolerance)))
                ++count;
        }
        active.push_back(i);
    }
    return count;
}

}  // namespace csg::reference
