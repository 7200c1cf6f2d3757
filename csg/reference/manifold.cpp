#include "csg/reference/manifold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct Edge {
    std::uint32_t lo, hi;
    std::uint32_t triangle;
    std::uint32_t corner;  ///< The edge runs from this corner of the triangle to the next.
    bool forward;          ///< From lo to hi.
};

std::vector<Edge> sorted_edges(const Mesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][static_cast<int>(k)];
            const std::uint32_t b = mesh.triangles[t][static_cast<int>((k + 1) % 3)];
            edges.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.lo, a.hi, a.triangle) < std::tie(b.lo, b.hi, b.triangle);
    });
    return edges;
}

class Separator {
  public:
    Separator(Mesh& mesh, std::span<const double> turns)
        : mesh_(mesh), turns_(turns), root_(mesh.triangles.size() * 3) {
        std::iota(root_.begin(), root_.end(), 0u);
    }

    /// Gives the edges (geometric ends) at which two sheets still share both ends: they touch there and are connected
    /// around each end.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> run() {
        std::vector<Edge> edges = sorted_edges(mesh_);
        for (std::size_t i = 0, j; i < edges.size(); i = j) {
            for (j = i + 1; j < edges.size() && edges[j].lo == edges[i].lo && edges[j].hi == edges[i].hi; ++j) {
            }
            if (j - i == 2) {
                join(edges[i], edges[i + 1]);
            } else {
                pair_up(std::span(edges).subspan(i, j - i));
            }
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> shared;
        for (std::size_t i = 0, j; i < edges.size(); i = j) {
            for (j = i + 1; j < edges.size() && edges[j].lo == edges[i].lo && edges[j].hi == edges[i].hi; ++j) {
            }
            if (j - i > 2 && still_shared(std::span(edges).subspan(i, j - i))) {
                shared.emplace_back(edges[i].lo, edges[i].hi);
            }
        }
        if (shared.empty()) {
            renumber();
        }
        return shared;
    }

  private:
    /// Around the edge, counter-clockwise seen against lo → hi, a forward triangle has the solid before it and a
    /// backward one behind it.
    void pair_up(std::span<Edge> around) {
        const auto turn = [&](const Edge& e) { return turns_.empty() ? 0 : turns_[3 * e.triangle + e.corner]; };
        std::stable_sort(around.begin(), around.end(), [&](const Edge& p, const Edge& q) { return turn(p) < turn(q); });
        for (std::size_t i = 0; i < around.size(); ++i) {
            const Edge &e = around[i], &next = around[(i + 1) % around.size()];
            if (!e.forward && next.forward) {
                join(e, next);
            }
        }
    }

    void join(const Edge& a, const Edge& b) {
        if (a.forward == b.forward) {
            return;  // not a boundary; the check of the result says so
        }
        unite(3 * a.triangle + a.corner, 3 * b.triangle + (b.corner + 1) % 3);
        unite(3 * a.triangle + (a.corner + 1) % 3, 3 * b.triangle + b.corner);
    }

    bool still_shared(std::span<const Edge> around) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        for (const Edge& e : around) {
            if (e.forward) {
                ends.emplace_back(find(3 * e.triangle + e.corner), find(3 * e.triangle + (e.corner + 1) % 3));
            }
        }
        std::sort(ends.begin(), ends.end());
        return std::adjacent_find(ends.begin(), ends.end()) != ends.end();
    }

    std::uint32_t find(std::uint32_t i) {
        while (root_[i] != i) {
            i = root_[i] = root_[root_[i]];
        }
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
    std::span<const double> turns_;
    std::vector<std::uint32_t> root_;  ///< By corner.
};

/// For a triangle divided in the middle of its edge from corner k on: itself and the new last one. The middle has a
/// larger number than both ends, so the half at the edge's larger end runs the other way.
void divide_turns(std::vector<double>& turns, std::size_t triangle, std::size_t k, bool forward) {
    if (turns.empty()) {
        return;
    }
    const std::array whole{turns[3 * triangle], turns[3 * triangle + 1], turns[3 * triangle + 2]};
    const double edge = whole[k], next = whole[(k + 1) % 3], last = whole[(k + 2) % 3];
    // {corner k, middle, corner k + 2} and {middle, corner k + 1, corner k + 2}
    const std::array own{forward ? edge : -edge, 0.0, last}, added{forward ? -edge : edge, next, 0.0};
    std::copy(own.begin(), own.end(), turns.begin() + static_cast<std::ptrdiff_t>(3 * triangle));
    turns.insert(turns.end(), added.begin(), added.end());
}

/// Divides the triangles at the edges (sorted) by a new point in the middle of each.
void divide(Mesh& mesh, std::vector<double>& turns, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const auto& [a, b] : edges) {
        mesh.points.push_back(0.5 * (mesh.points[a] + mesh.points[b]));
    }
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto key = std::minmax(a, b);
        const auto at = std::lower_bound(edges.begin(), edges.end(), std::pair(key.first, key.second));
        const bool found = at != edges.end() && at->first == key.first && at->second == key.second;
        return found ? first + static_cast<std::uint32_t>(at - edges.begin()) : kNone;
    };
    // What a division makes is looked at again: a triangle may have more than one such edge.
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const glm::uvec3 whole = mesh.triangles[t];
            const std::uint32_t m = middle(whole[k], whole[(k + 1) % 3]);
            if (m == kNone) {
                continue;
            }
            mesh.triangles[t] = {whole[k], m, whole[(k + 2) % 3]};
            mesh.triangles.emplace_back(m, whole[(k + 1) % 3], whole[(k + 2) % 3]);
            mesh.sources.push_back(mesh.sources[t]);
            divide_turns(turns, t, static_cast<std::size_t>(k), whole[k] < whole[(k + 1) % 3]);
            k = -1;
        }
    }
}

/// By the angles of the triangles around each edge that more than two share.
std::vector<double> turns_of(const Mesh& mesh, std::span<const glm::dvec3> normals) {
    std::vector<double> turns(3 * mesh.triangles.size());
    const std::vector<Edge> edges = sorted_edges(mesh);
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        for (j = i + 1; j < edges.size() && edges[j].lo == edges[i].lo && edges[j].hi == edges[i].hi; ++j) {
        }
        if (j - i == 2) {
            continue;
        }
        const glm::dvec3 along = glm::normalize(mesh.points[edges[i].hi] - mesh.points[edges[i].lo]);
        const glm::dvec3 a = glm::abs(along);
        const glm::dvec3 helper = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                                  : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                           : glm::dvec3(0, 0, 1);
        const glm::dvec3 x = glm::normalize(glm::cross(along, helper)), y = glm::cross(along, x);
        for (std::size_t k = i; k < j; ++k) {
            const Edge& e = edges[k];
            const glm::dvec3 into = glm::cross(normals[e.triangle], along) * (e.forward ? 1.0 : -1.0);
            turns[3 * e.triangle + e.corner] = std::atan2(glm::dot(into, y), glm::dot(into, x));
        }
    }
    return turns;
}

}  // namespace

void separate_sheets(Mesh& mesh, std::vector<double> turns) {
    const auto shared = Separator(mesh, turns).run();
    if (shared.empty()) {
        return;
    }
    divide(mesh, turns, shared);
    // Around the new points the sheets are apart, so nothing is shared any more. Were it so, the points would stay as
    // they are and the check of the result would find the edge.
    (void)Separator(mesh, turns).run();
}

void separate_sheets(Mesh& mesh, std::span<const glm::dvec3> normals) {
    separate_sheets(mesh, turns_of(mesh, normals));
}

}  // namespace csg::reference
