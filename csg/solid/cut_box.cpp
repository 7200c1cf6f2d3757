#include "csg/solid/cut_box.h"

#include <array>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "csg/solid/edge_crossings.h"
#include "csg/solid/no_index.h"
#include "csg/solid/used_points.h"

namespace csg::solid {
namespace {

/// Corners are numbered by the bits x, y, z: set at the upper end. Counter-clockwise seen from outside.
constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

std::vector<glm::dvec3> corners_of(const Box& box) {
    std::vector<glm::dvec3> corners;
    for (std::uint32_t i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1U) != 0 ? box.hi.x : box.lo.x, (i & 2U) != 0 ? box.hi.y : box.lo.y,
                             (i & 4U) != 0 ? box.hi.z : box.lo.z);
    }
    return corners;
}

std::vector<double> depths_of(std::span<const glm::dvec3> points, const Plane& plane) {
    std::vector<double> depths;
    for (const glm::dvec3& p : points) {
        depths.push_back(plane.offset - glm::dot(plane.normal, p));
    }
    return depths;
}

class BoxCutter {
  public:
    BoxCutter(const Box& box, const Plane& plane)
        : points_(corners_of(box)), crossings_(points_, depths_of(points_, plane)) {}

    CutBox cut() {
        for (const auto& face : kFaces) {
            cut(face);
        }
        CutBox result;
        auto solid = std::make_shared<Solid>();
        // The cut is a convex polygon.
        if (!next_.empty()) {
            const std::uint32_t first = next_.begin()->first;
            for (std::uint32_t b = next_[first], c = next_[b]; c != first; b = c, c = next_[c]) {
                solid->triangles.emplace_back(first, b, c);
            }
        }
        result.face_triangles = static_cast<std::uint32_t>(solid->triangles.size());
        solid->triangles.insert(solid->triangles.end(), triangles_.begin(), triangles_.end());
        solid->points = used_points(points_, solid->triangles);
        for (const glm::dvec3& p : solid->points) {
            solid->box = enclose(solid->box, p);
        }
        solid->convex = solid->closed = solid->simple = true;
        result.solid = std::move(solid);
        return result;
    }

  private:
    void cut(const std::array<std::uint32_t, 4>& face) {
        std::array<std::uint32_t, 6> polygon{};
        std::size_t count = 0;
        std::uint32_t leaving = kNone, entering = kNone;
        const auto add = [&](std::uint32_t p) {
            if (count == 0 || polygon[count - 1] != p) {
                polygon[count++] = p;
            }
        };
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t p = face[i], q = face[(i + 1) % 4];
            const bool from_inside = crossings_.inside(p), to_inside = crossings_.inside(q);
            if (from_inside) {
                add(p);
            }
            if (from_inside && !to_inside) {
                add(leaving = crossings_.crossing(p, q));
            } else if (!from_inside && to_inside) {
                add(entering = crossings_.crossing(q, p));
            }
        }
        if (count > 1 && polygon[count - 1] == polygon[0]) {
            --count;
        }
        for (std::size_t i = 2; i < count; ++i) {
            triangles_.emplace_back(polygon[0], polygon[i - 1], polygon[i]);
        }
        if (leaving != kNone && leaving != entering) {
            next_[entering] = leaving;
        }
    }

    std::vector<glm::dvec3> points_;
    EdgeCrossings crossings_;
    std::map<std::uint32_t, std::uint32_t> next_;  ///< Around the cut.
    std::vector<glm::uvec3> triangles_;
};

}  // namespace

CutBox cut_box(const Box& box, const Plane& plane) {
    return BoxCutter(box, plane).cut();
}

}  // namespace csg::solid
