// A plane seen along the axis it faces most.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace csg::reference {

/// Drops one coordinate, so that what turns counter-clockwise about the plane's normal does so in the picture.
class PlaneAxes {
  public:
    explicit PlaneAxes(const glm::dvec3& normal) {
        const glm::dvec3 n = glm::abs(normal);
        const int axis = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
        u_ = (axis + 1) % 3;
        v_ = (axis + 2) % 3;
        if (normal[axis] < 0) {
            std::swap(u_, v_);
        }
    }
    [[nodiscard]] glm::dvec2 operator()(const glm::dvec3& p) const { return {p[u_], p[v_]}; }

  private:
    int u_, v_;
};

}  // namespace csg::reference
