#include "csg/reference/simple_leaf.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"
#include "csg/reference/components.h"
#include "csg/reference/manifold.h"
#include "csg/reference/simple_prism.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool all_have_area(const Mesh& mesh) {
    const auto at = [&](std::uint32_t i) {
        return Kernel::Point_3(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    };
    return std::none_of(mesh.triangles.begin(), mesh.triangles.end(),
                        [&](const glm::uvec3& t) { return CGAL::collinear(at(t.x), at(t.y), at(t.z)); });
}

/// Whether triangles of a closed manifold mesh meet anywhere but where they share corners.
class Meeting {
  public:
    explicit Meeting(const Mesh& mesh) : mesh_(mesh) {}

    [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const {
        const glm::uvec3 &t = mesh_.triangles[a], &u = mesh_.triangles[b];
        const std::array<int, 3> of_u = sides(t, u), of_t = sides(u, t);
        const auto [least_u, most_u] = std::minmax({of_u[0], of_u[1], of_u[2]});
        const auto [least_t, most_t] = std::minmax({of_t[0], of_t[1], of_t[2]});
        if (least_u > 0 || most_u < 0 || least_t > 0 || most_t < 0) {
            return false;
        }
        if (least_u == 0 && most_u == 0) {
            return overlap(t, u);
        }
        return reaches(t, u, of_u) || reaches(u, t, of_t);
    }

  private:
    [[nodiscard]] Kernel::Point_3 at(std::uint32_t i) const {
        return {mesh_.points[i].x, mesh_.points[i].y, mesh_.points[i].z};
    }
    static bool has(const glm::uvec3& t, std::uint32_t corner) {
        return t.x == corner || t.y == corner || t.z == corner;
    }

    [[nodiscard]] std::array<int, 3> sides(const glm::uvec3& of, const glm::uvec3& corners) const {
        std::array<int, 3> result{};
        for (int k = 0; k < 3; ++k) {
            if (!has(of, corners[k])) {
                result[static_cast<std::size_t>(k)] = CGAL::orientation(at(of.x), at(of.y), at(of.z), at(corners[k]));
            }
        }
        return result;
    }

    /// Does an edge of `u` pass through `t`, or a corner that is not shared lie in it? `sides`: of u's corners.
    [[nodiscard]] bool reaches(const glm::uvec3& t, const glm::uvec3& u, const std::array<int, 3>& sides) const {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t p = u[k], q = u[(k + 1) % 3];
            const int from = sides[static_cast<std::size_t>(k)], to = sides[static_cast<std::size_t>((k + 1) % 3)];
            if (from * to < 0 && pierces(p, q, t)) {
                return true;
            }
            // Beside a corner that is shared the line to it would only tell what is known.
            if (from == 0 && !has(t, p) && holds(t, p)) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] bool pierces(std::uint32_t from, std::uint32_t to, const glm::uvec3& t) const {
        const auto p = at(from), q = at(to);
        int least = 1, most = -1;
        for (int k = 0; k < 3; ++k) {
            const int way = CGAL::orientation(p, q, at(t[k]), at(t[(k + 1) % 3]));
            least = std::min(least, way);
            most = std::max(most, way);
        }
        return least >= 0 || most <= 0;
    }

    [[nodiscard]] static int turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        return CGAL::orientation(Kernel::Point_2(a[u], a[v]), Kernel::Point_2(b[u], b[v]), Kernel::Point_2(c[u], c[v]));
    }

    /// An axis along which the triangle is seen with an area, and which way around it turns there.
    [[nodiscard]] std::pair<int, int> view(const glm::uvec3& t) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (const int way = turn(mesh_.points[t.x], mesh_.points[t.y], mesh_.points[t.z], axis); way != 0) {
                return {axis, way};
            }
        }
        return {0, 0};  // not reached: all triangles have an area
    }

    /// Is a point of the triangle's plane in it, its border included?
    [[nodiscard]] bool holds(const glm::uvec3& t, std::uint32_t point) const {
        const auto [axis, way] = view(t);
        for (int k = 0; k < 3; ++k) {
            if (turn(mesh_.points[t[k]], mesh_.points[t[(k + 1) % 3]], mesh_.points[point], axis) == -way) {
                return false;
            }
        }
        return true;
    }

    /// Do triangles in one plane share an area? Not where an edge of one has the other beyond it.
    [[nodiscard]] bool overlap(const glm::uvec3& t, const glm::uvec3& u) const {
        const int axis = view(t).first;
        const auto apart = [&](const glm::uvec3& a, const glm::uvec3& b) {
            const int way = turn(mesh_.points[a.x], mesh_.points[a.y], mesh_.points[a.z], axis);
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 &p = mesh_.points[a[k]], &q = mesh_.points[a[(k + 1) % 3]];
                if (turn(p, q, mesh_.points[b.x], axis) * way <= 0 && turn(p, q, mesh_.points[b.y], axis) * way <= 0 &&
                    turn(p, q, mesh_.points[b.z], axis) * way <= 0) {
                    return true;
                }
            }
            return false;
        };
        return !apart(t, u) && !apart(u, t);
    }

    const Mesh& mesh_;
};

bool meets_itself(const Mesh& mesh, const std::stop_token& stop) {
    if (const std::optional<bool> meets = prism_meets_itself(mesh, stop)) {
        return *meets;
    }
    const std::vector<Box> boxes = triangle_boxes(mesh.points, mesh.triangles);
    const Meeting meeting(mesh);
    base::PacedStop paced(stop);
    bool found = false;
    BoxTree(boxes).pairs([&](std::uint32_t a, std::uint32_t b) {
        paced();
        found = found || meeting.meet(a, b);
    });
    return found;
}

}  // namespace

std::optional<SimpleSurface> simple_surface(const solid::PlacedLeaf& leaf, const std::stop_token& stop) {
    // What trimming has closed (csg/solid/trim_leaves.h) may overlap itself in a plane; that is found below.
    if (!leaf.solid->closed) {
        return {};
    }
    Mesh mesh = welded(leaf.points, leaf.triangles);
    if (!all_have_area(mesh)) {
        return {};
    }
    if (!leaf.solid->convex) {
        separate_sheets(mesh, std::vector<double>());  // those that share but a corner
    }
    const MeshFacts f = facts(mesh);
    if (!f.manifold || f.components != 1 || !(f.volume > 0)) {
        return {};
    }
    if (!leaf.solid->convex && meets_itself(mesh, stop)) {
        return {};
    }
    return SimpleSurface{std::move(mesh), f};
}

}  // namespace csg::reference
