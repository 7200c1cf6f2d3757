#include "csg/solid/cut_box.h"

#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace csg::solid {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Corners are numbered by the bits x, y, z: set at the upper end. Counter-clockwise seen from outside.
constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

class BoxCutter {
  public:
    BoxCutter(const Box& box, const Plane& plane) {
        for (std::uint32_t i = 0; i < 8; ++i) {
            points_.emplace_back((i & 1U) != 0 ? box.hi.x : box.lo.x, (i & 2U) != 0 ? box.hi.y : box.lo.y,
                                 (i & 4U) != 0 ? box.hi.z : box.lo.z);
            depths_[i] = plane.offset - glm::dot(plane.normal, points_.back());
        }
    }

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
        std::vector<std::uint32_t> place(points_.size(), kNone);
        for (glm::uvec3& t : solid->triangles) {
            for (int i = 0; i < 3; ++i) {
                std::uint32_t& at = place[t[i]];
                if (at == kNone) {
                    at = static_cast<std::uint32_t>(solid->points.size());
                    solid->points.push_back(points_[t[i]]);
                    solid->box = enclose(solid->box, points_[t[i]]);
                }
                t[i] = at;
            }
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
            if (inside(p)) {
                add(p);
            }
            if (inside(p) && !inside(q)) {
                add(leaving = crossing(p, q));
            } else if (!inside(p) && inside(q)) {
                add(entering = crossing(q, p));
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

    [[nodiscard]] bool inside(std::uint32_t corner) const { return depths_[corner] >= 0; }

    std::uint32_t crossing(std::uint32_t in, std::uint32_t out) {
        if (depths_[in] == 0) {
            return in;
        }
        const auto [at, is_new] = crossings_.try_emplace({in, out}, static_cast<std::uint32_t>(points_.size()));
        if (is_new) {
            const glm::dvec3 p = points_[in], q = points_[out];
            points_.push_back(p + (q - p) * (depths_[in] / (depths_[in] - depths_[out])));
        }
        return at->second;
    }

    std::vector<glm::dvec3> points_;
    std::array<double, 8> depths_{};  ///< Of the corners, below the plane.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
    std::map<std::uint32_t, std::uint32_t> next_;  ///< Around the cut.
    std::vector<glm::uvec3> triangles_;
};

}  // namespace

CutBox cut_box(const Box& box, const Plane& plane) {
    return BoxCutter(box, plane).cut();
}

}  // namespace csg::solid
