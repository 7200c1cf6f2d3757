#include "csg/reference/convex.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "csg/reference/hull.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

/// Up to so many sums all are formed.
constexpr std::size_t kFewSums = 2048;
/// Up to so many points all are looked at for the farthest.
constexpr std::size_t kFewPoints = 24;
constexpr double kBeyond = 0x1p-40;

class Summer {
  public:
    Summer(const Convex& a, const Convex& b)
        : a_(a), b_(b), beyond_(kBeyond * (largest_coordinate(a.points()) + largest_coordinate(b.points()))) {}

    Mesh sum(const std::stop_token& stop) {
        extremes_along(a_.normals(), a_);
        extremes_along(b_.normals(), b_);
        for (;;) {
            Mesh mesh = hull(points_, stop);
            if (mesh.empty() || !grow(mesh)) {
                return mesh;
            }
        }
    }

  private:
    struct Pair {
        std::uint32_t a, b;
    };

    bool add(Pair pair) {
        const glm::dvec3 at = a_.points()[pair.a] + b_.points()[pair.b];
        const bool added = ids_.add(at).second;
        if (added) {
            points_.push_back(at);
            pairs_.push_back(pair);
        }
        return added;
    }

    /// For each normal, what is farthest along it, and around it: a face of one, swept by what is farthest of the
    /// other.
    void extremes_along(const std::vector<glm::dvec3>& normals, const Convex& owner) {
        Pair at{0, 0};
        for (std::size_t i = 0; i < normals.size(); ++i) {
            at = {a_.farthest(normals[i], at.a), b_.farthest(normals[i], at.b)};
            add(at);
            const auto corner = [&](std::uint32_t own) { add(&owner == &a_ ? Pair{own, at.b} : Pair{at.a, own}); };
            if (!owner.triangles().empty()) {
                for (int k = 0; k < 3; ++k) {
                    corner(owner.triangles()[i][k]);
                }
            } else {
                for (std::uint32_t k = 0; k < owner.points().size(); ++k) {
                    corner(k);
                }
            }
        }
    }

    /// Adds what lies beyond the faces; true where something does.
    bool grow(const Mesh& mesh) {
        std::vector<Pair> pairs;
        pairs.reserve(mesh.points.size());
        for (const glm::dvec3& p : mesh.points) {
            pairs.push_back(pairs_[ids_.add(p).first]);
        }
        bool grown = false;
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 &p = mesh.points[t.x], &q = mesh.points[t.y], &r = mesh.points[t.z];
            const glm::dvec3 normal = glm::cross(q - p, r - p);
            const double length = glm::length(normal);
            if (!(length > 0)) {
                continue;
            }
            const Pair at{a_.farthest(normal, pairs[t.x].a), b_.farthest(normal, pairs[t.x].b)};
            const double most = std::max({glm::dot(normal, p), glm::dot(normal, q), glm::dot(normal, r)});
            if (glm::dot(normal, a_.points()[at.a] + b_.points()[at.b]) - most > beyond_ * length) {
                grown |= add(at);
            }
        }
        return grown;
    }

    const Convex &a_, &b_;
    double beyond_;
    PointIds ids_;
    std::vector<glm::dvec3> points_;  ///< By id.
    std::vector<Pair> pairs_;         ///< By id.
};

}  // namespace

Convex Convex::hull_of(std::span<const glm::dvec3> points, const std::stop_token& stop) {
    Convex result;
    result.mesh_ = hull(points, stop);
    result.connect();
    return result;
}

Convex Convex::polygon(std::vector<glm::dvec3> corners) {
    Convex result;
    result.mesh_.points = std::move(corners);
    return result;
}

void Convex::connect() {
    first_.assign(mesh_.points.size() + 1, 0);
    for (const glm::uvec3& t : mesh_.triangles) {
        for (int k = 0; k < 3; ++k) {
            ++first_[t[k] + 1];
        }
    }
    for (std::size_t i = 1; i < first_.size(); ++i) {
        first_[i] += first_[i - 1];
    }
    neighbors_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const glm::uvec3& t : mesh_.triangles) {
        for (int k = 0; k < 3; ++k) {
            neighbors_[next[t[k]]++] = t[(k + 1) % 3];
        }
    }
}

std::vector<glm::dvec3> Convex::normals() const {
    std::vector<glm::dvec3> normals;
    const std::vector<glm::dvec3>& p = mesh_.points;
    for (const glm::uvec3& t : mesh_.triangles) {
        normals.push_back(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
    }
    if (mesh_.triangles.empty() && !p.empty()) {
        glm::dvec3 sum(0.0);
        for (std::size_t i = 1; i + 1 < p.size(); ++i) {
            sum += glm::cross(p[i] - p[0], p[i + 1] - p[0]);
        }
        normals = {sum, -sum};
    }
    return normals;
}

std::uint32_t Convex::farthest(const glm::dvec3& direction, std::uint32_t from) const {
    std::uint32_t best = from;
    double most = glm::dot(direction, mesh_.points[best]);
    const auto look = [&](std::uint32_t point) {
        const double height = glm::dot(direction, mesh_.points[point]);
        if (height > most) {
            most = height;
            best = point;
        }
    };
    if (neighbors_.empty() || mesh_.points.size() <= kFewPoints) {
        for (std::uint32_t i = 0; i < mesh_.points.size(); ++i) {
            look(i);
        }
        return best;
    }
    for (std::uint32_t at = from;; at = best) {
        for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i) {
            look(neighbors_[i]);
        }
        if (best == at) {
            return best;
        }
    }
}

glm::dvec3 Convex::middle() const {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& p : mesh_.points) {
        sum += p;
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, mesh_.points.size()));
}

Mesh sum_of_convex(const Convex& a, const Convex& b, const std::stop_token& stop) {
    if (a.empty() || b.empty()) {
        return {};
    }
    if (a.points().size() > kFewSums / b.points().size()) {
        return Summer(a, b).sum(stop);
    }
    std::vector<glm::dvec3> sums;
    sums.reserve(a.points().size() * b.points().size());
    for (const glm::dvec3& p : a.points()) {
        for (const glm::dvec3& q : b.points()) {
            sums.push_back(p + q);
        }
    }
    return hull(sums, stop);
}

}  // namespace csg::reference
