#include "csg/reference/manifold.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct Edge {
    std::uint32_t lo, hi;
    std::uint32_t triangle;
    std::uint32_t corner;  ///< The edge runs from this corner of the triangle to the next.
    bool forward;          ///< From lo to hi.
    double angle = 0;
};

class Separator {
  public:
    Separator(Mesh& mesh, std::span<const glm::dvec3> normals)
        : mesh_(mesh), normals_(normals), root_(mesh.triangles.size() * 3) {
        std::iota(root_.begin(), root_.end(), 0u);
    }

    void run() {
        std::vector<Edge> edges = sorted_edges();
        for (std::size_t i = 0, j; i < edges.size(); i = j) {
            for (j = i + 1; j < edges.size() && edges[j].lo == edges[i].lo && edges[j].hi == edges[i].hi; ++j) {
            }
            if (j - i == 2)
                join(edges[i], edges[i + 1]);
            else
                pair_up(std::span(edges).subspan(i, j - i));
        }
        renumber();
    }

  private:
    std::vector<Edge> sorted_edges() const {
        std::vector<Edge> edges;
        edges.reserve(mesh_.triangles.size() * 3);
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t a = mesh_.triangles[t][static_cast<int>(k)];
                const std::uint32_t b = mesh_.triangles[t][static_cast<int>((k + 1) % 3)];
                edges.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
            }
        }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return std::tie(a.lo, a.hi, a.triangle) < std::tie(b.lo, b.hi, b.triangle);
        });
        return edges;
    }

    /// Around the edge, counter-clockwise seen against lo → hi, a forward triangle has the solid before it and a
    /// backward one behind it.
    void pair_up(std::span<Edge> around) {
        const glm::dvec3 along = glm::normalize(mesh_.points[around[0].hi] - mesh_.points[around[0].lo]);
        const glm::dvec3 a = glm::abs(along);
        const glm::dvec3 helper = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                                  : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                           : glm::dvec3(0, 0, 1);
        const glm::dvec3 x = glm::normalize(glm::cross(along, helper)), y = glm::cross(along, x);
        for (Edge& e : around) {
            const glm::dvec3 into = glm::cross(normals_[e.triangle], along) * (e.forward ? 1.0 : -1.0);
            e.angle = std::atan2(glm::dot(into, y), glm::dot(into, x));
        }
        std::sort(around.begin(), around.end(), [](const Edge& p, const Edge& q) { return p.angle < q.angle; });
        for (std::size_t i = 0; i < around.size(); ++i) {
            const Edge &e = around[i], &next = around[(i + 1) % around.size()];
            if (!e.forward && next.forward)
                join(e, next);
        }
    }

    void join(const Edge& a, const Edge& b) {
        if (a.forward == b.forward)
            return;  // not a boundary; the check of the result says so
        unite(3 * a.triangle + a.corner, 3 * b.triangle + (b.corner + 1) % 3);
        unite(3 * a.triangle + (a.corner + 1) % 3, 3 * b.triangle + b.corner);
    }

    std::uint32_t find(std::uint32_t i) {
        while (root_[i] != i)
            i = root_[i] = root_[root_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        root_[std::max(a, b)] = std::min(a, b);
    }

    void renumber() {
        std::vector<std::uint32_t> number(root_.size(), kNone);
        std::vector<glm::dvec3> points;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                std::uint32_t& corner = mesh_.triangles[t][static_cast<int>(k)];
                std::uint32_t& n = number[find(3 * t + k)];
                if (n == kNone) {
                    n = static_cast<std::uint32_t>(points.size());
                    points.push_back(mesh_.points[corner]);
                }
                corner = n;
            }
        }
        mesh_.points = std::move(points);
    }

    Mesh& mesh_;
    std::span<const glm::dvec3> normals_;
    std::vector<std::uint32_t> root_;  ///< By corner.
};

}  // namespace

void separate_sheets(Mesh& mesh, std::span<const glm::dvec3> normals) {
    Separator(mesh, normals).run();
}

}  // namespace csg::reference
