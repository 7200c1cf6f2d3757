#include "ui/pipeline/motion/rigid_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "ui/pipeline/inspection/triangle_distance.h"

namespace ui {

namespace {

/// Between two boxes: 0 where they meet.
double apart(const csg::Box& a, const csg::Box& b) {
    return glm::length(glm::max(glm::dvec3(0.0), glm::max(a.lo - b.hi, b.lo - a.hi)));
}

}  // namespace

RigidMesh::RigidMesh(std::vector<glm::dvec3> points, std::vector<glm::uvec3> triangles)
    : points_(std::move(points)),
      triangles_(std::move(triangles)),
      boxes_(csg::reference::triangle_boxes(points_, triangles_)),
      tree_(boxes_) {
    for (const csg::Box& box : boxes_) {
        box_ = csg::enclose(box_, box);
    }
}

std::vector<std::unique_ptr<const RigidMesh>> RigidMesh::pieces() const {
    csg::reference::DisjointSets sets(points_.size());
    for (const glm::uvec3& t : triangles_) {
        sets.unite(t.x, t.y);
        sets.unite(t.x, t.z);
    }
    std::map<std::uint32_t, std::vector<glm::uvec3>> by_set;
    for (const glm::uvec3& t : triangles_) {
        by_set[sets.find(t.x)].push_back(t);
    }
    std::vector<std::unique_ptr<const RigidMesh>> result;
    for (auto& [set, triangles] : by_set) {
        std::map<unsigned, unsigned> own;
        std::vector<glm::dvec3> points;
        for (glm::uvec3& t : triangles) {
            for (int i = 0; i < 3; ++i) {
                const auto [at, fresh] = own.try_emplace(t[i], static_cast<unsigned>(points.size()));
                if (fresh) {
                    points.push_back(points_[t[i]]);
                }
                t[i] = at->second;
            }
        }
        result.push_back(std::make_unique<const RigidMesh>(std::move(points), std::move(triangles)));
    }
    return result;
}

/// Solid angles of triangles: van Oosterom and Strackee 1983.
bool RigidMesh::holds(const glm::dvec3& point) const {
    if (glm::any(glm::lessThan(point, box_.lo)) || glm::any(glm::greaterThan(point, box_.hi))) {
        return false;
    }
    double angle = 0;
    for (const glm::uvec3& t : triangles_) {
        const glm::dvec3 a = points_[t.x] - point, b = points_[t.y] - point, c = points_[t.z] - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        angle += 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi;
}

RigidMesh::Near RigidMesh::nearest(const RigidMesh& a, const glm::dmat4& motion_a, const RigidMesh& b,
                                   const glm::dmat4& motion_b) {
    // In the coordinates of the second, where its boxes are.
    const glm::dmat4 to_b = glm::inverse(motion_b) * motion_a;
    std::vector<glm::dvec3> moved;
    moved.reserve(a.points_.size());
    for (const glm::dvec3& p : a.points_) {
        moved.emplace_back(to_b * glm::dvec4(p, 1));
    }
    // Those first that are nearest to the other's box: what they find spares most of the rest.
    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(a.triangles_.size());
    const std::vector<csg::Box> boxes = csg::reference::triangle_boxes(moved, a.triangles_);
    for (std::uint32_t i = 0; i < a.triangles_.size(); ++i) {
        order.emplace_back(apart(boxes[i], b.box_), i);
    }
    std::sort(order.begin(), order.end());
    const auto corners = [](const std::vector<glm::dvec3>& points, const glm::uvec3& t) {
        return Corners{points[t.x], points[t.y], points[t.z]};
    };
    Near best{glm::distance(moved[a.triangles_.front().x], b.points_[b.triangles_.front().x]),
              moved[a.triangles_.front().x], b.points_[b.triangles_.front().x]};
    for (const auto& next : order) {
        if (next.first > best.distance) {
            break;
        }
        const std::uint32_t i = next.second;
        const Corners own = corners(moved, a.triangles_[i]);
        const csg::Box& box = boxes[i];
        b.tree_.meeting({box.lo - best.distance, box.hi + best.distance}, [&](std::uint32_t k) {
            if (apart(box, b.boxes_[k]) < best.distance) {
                const Nearest found = nearest_points(own, corners(b.points_, b.triangles_[k]));
                if (found.distance < best.distance) {
                    best = {found.distance, found.a, found.b};
                }
            }
        });
    }
    best.a = glm::dvec3(motion_b * glm::dvec4(best.a, 1));
    best.b = glm::dvec3(motion_b * glm::dvec4(best.b, 1));
    return best;
}

}  // namespace ui
