#include "csg/reference/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"

namespace csg::reference {
namespace {

class Triangle {
  public:
    explicit Triangle(const std::array<glm::dvec3, 3>& corners) : corners_(corners) {
        normal_ = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(normal_);
        normal_ = length > 0 ? normal_ / length : glm::dvec3(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            box_ = enclose(box_, corners[i]);
            if (!degenerate()) {
                inward_[i] = glm::normalize(glm::cross(normal_, corners[(i + 1) % 3] - corners[i]));
            }
        }
    }

    [[nodiscard]] const Box& box() const { return box_; }

    [[nodiscard]] bool degenerate() const { return normal_ == glm::dvec3(0.0); }

    /// Do the triangles cross, or overlap in one plane, by more than the tolerance? Not where this one is degenerate,
    /// nor where they face opposite ways in one plane: those are sheets that touch.
    [[nodiscard]] bool crosses(const Triangle& other, double tolerance, Overlaps overlaps) const {
        const std::array<double, 3> d = distances(other);
        const auto [least, most] = std::minmax_element(d.begin(), d.end());
        if (*least >= -tolerance && *most <= tolerance) {
            return overlaps == Overlaps::Counted && glm::dot(normal_, other.normal_) > 0 &&
                   !apart(*this, other, tolerance) && !apart(other, *this, tolerance);
        }
        if (*least >= -tolerance || *most <= tolerance) {
            return false;  // on one side, as nearly all neighbors are
        }
        return pierced_by(other, d, tolerance) ||
               (!other.degenerate() && other.pierced_by(*this, other.distances(*this), tolerance));
    }

  private:
    [[nodiscard]] bool inside(const glm::dvec3& p, double tolerance) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (glm::dot(inward_[i], p - corners_[i]) <= tolerance) {
                return false;
            }
        }
        return true;
    }

    /// Of the other's corners from this one's plane.
    [[nodiscard]] std::array<double, 3> distances(const Triangle& other) const {
        std::array<double, 3> d;
        for (std::size_t i = 0; i < 3; ++i) {
            d[i] = glm::dot(normal_, other.corners_[i] - corners_[0]);
        }
        return d;
    }

    /// Does an edge of `other` pass through the inside, by more than the tolerance on both sides and at all edges?
    [[nodiscard]] bool pierced_by(const Triangle& other, const std::array<double, 3>& d, double tolerance) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            if ((d[i] > tolerance && d[j] < -tolerance) || (d[i] < -tolerance && d[j] > tolerance)) {
                const glm::dvec3 at =
                    other.corners_[i] + (other.corners_[j] - other.corners_[i]) * (d[i] / (d[i] - d[j]));
                if (inside(at, tolerance)) {
                    return true;
                }
            }
        }
        return false;
    }

    static bool apart(const Triangle& a, const Triangle& b, double tolerance) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3& in = a.inward_[i];
            if (std::all_of(b.corners_.begin(), b.corners_.end(),
                            [&](const glm::dvec3& p) { return glm::dot(in, p - a.corners_[i]) <= tolerance; })) {
                return true;
            }
        }
        return false;
    }

    std::array<glm::dvec3, 3> corners_;
    std::array<glm::dvec3, 3> inward_;  ///< By edge, from corner i on: in the plane, of unit length.
    glm::dvec3 normal_;
    Box box_;
};

}  // namespace

std::size_t count_self_intersections(const Mesh& mesh, double tolerance, Overlaps overlaps,
                                     const std::stop_token& stop) {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        triangles.emplace_back(std::array{mesh.points[t.x], mesh.points[t.y], mesh.points[t.z]});
    }
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        boxes.push_back(t.box());
    }
    base::end_if_asked(stop);
    base::PacedStop paced(stop);
    std::size_t count = 0;
    BoxTree(boxes).pairs([&](std::uint32_t a, std::uint32_t b) {
        paced();
        const Triangle &t = triangles[a], &u = triangles[b];
        if (t.degenerate() ? !u.degenerate() && u.crosses(t, tolerance, overlaps) : t.crosses(u, tolerance, overlaps)) {
            ++count;
        }
    });
    return count;
}

}  // namespace csg::reference
