// Surfaces of bodies that are put elsewhere, and how near two come to each other.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "csg/reference/box_pairs.h"
#include "csg/tree/box.h"

namespace ui {

class RigidMesh {
  public:
    RigidMesh(std::vector<glm::dvec3> points, std::vector<glm::uvec3> triangles);
    RigidMesh(const RigidMesh&) = delete;
    RigidMesh& operator=(const RigidMesh&) = delete;

    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    [[nodiscard]] const csg::Box& box() const { return box_; }

    /// What of it hangs together by common points.
    [[nodiscard]] std::vector<std::unique_ptr<const RigidMesh>> pieces() const;

    /// Is the point (in its own coordinates) inside of it, by the winding number? Of no use on the surface.
    [[nodiscard]] bool holds(const glm::dvec3& point) const;

    struct Near {
        double distance = 0;
        glm::dvec3 a{0.0}, b{0.0};  ///< World coordinates: the nearest points.
    };
    /// Between the surfaces of two that are not empty, each led by a motion that keeps distances.
    [[nodiscard]] static Near nearest(const RigidMesh& a, const glm::dmat4& motion_a, const RigidMesh& b,
                                      const glm::dmat4& motion_b);

  private:
    std::vector<glm::dvec3> points_;
    std::vector<glm::uvec3> triangles_;
    csg::Box box_;
    std::vector<csg::Box> boxes_;  ///< By triangle.
    csg::reference::BoxTree tree_;
};

}  // namespace ui
