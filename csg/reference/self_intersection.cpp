#include "csg/reference/self_intersection.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>

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

    [[nodiscard]] bool degenerate() const { return normal_ == glm::dvec3(0.0); }

    /// Do the triangles cross, or overlap in one plane, by more than the tolerance? Not where this one is degenerate.
    [[nodiscard]] bool crosses(const Triangle& other, double tolerance) const {
        const std::array<double, 3> d = distances(other);
        const auto [least, most] = std::minmax_element(d.begin(), d.end());
        if (*least >= -tolerance && *most <= tolerance)
            return !other.degenerate() && !apart(*this, other, tolerance) && !apart(other, *this, tolerance);
        if (*least >= -tolerance || *most <= tolerance)
            return false;  // on one side, as nearly all neighbours are
        return pierced_by(other, d, tolerance) ||
               (!other.degenerate() && other.pierced_by(*this, other.distances(*this), tolerance));
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

    /// Of the other's corners from this one's plane.
    [[nodiscard]] std::array<double, 3> distances(const Triangle& other) const {
        std::array<double, 3> d;
        for (std::size_t i = 0; i < 3; ++i)
            d[i] = glm::dot(normal_, other.corners_[i] - corners_[0]);
        return d;
    }

    /// Does an edge of `other` pass through the inside, by more than the tolerance on both sides and at all edges?
    [[nodiscard]] bool pierced_by(const Triangle& other, const std::array<double, 3>& d, double tolerance) const {
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
    // Pairs whose boxes meet, by a tree of segments (Zomorodian and Edelsbrunner 2000).
    using Item = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Triangle*>;
    std::vector<Item> items;
    items.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        const Box& b = t.box();
        items.emplace_back(CGAL::Bbox_3(b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z), &t);
    }
    std::size_t count = 0;
    CGAL::box_self_intersection_d(items.begin(), items.end(), [&](const Item& a, const Item& b) {
        const Triangle &t = *a.handle(), &u = *b.handle();
        if (t.degenerate() ? !u.degenerate() && u.crosses(t, tolerance) : t.crosses(u, tolerance))
            ++count;
    });
    return count;
}

}  // namespace csg::reference
