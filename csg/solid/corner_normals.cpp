#include "csg/solid/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace csg::solid {
namespace {

/// A corner of a triangle: three times its number, and which one.
using CornerId = std::uint32_t;

/// About a cone's tip all normals are as far from its axis as those of the facets; about the pole of a sphere those of
/// the next corners are twice as far.
constexpr double kPole = 1.3;
constexpr double kFlatTip = 0.9998;  // Cosine.

double angle(const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

glm::dvec3 direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

class Normals {
  public:
    Normals(const PlacedLeaf& leaf, std::span<const FacetGroup> groups) : leaf_(leaf), groups_(groups) {
        for (const FacetGroup group : groups) {
            if (group.bend() > 0) {
                curved_.insert(group.surface());
            }
        }
    }

    [[nodiscard]] bool none() const { return curved_.empty(); }

    std::vector<CornerNormals> find() {
        measure_facets();
        gather_corners();
        normals_.assign(leaf_.triangles.size(), CornerNormals{});
        for (std::size_t point = 0; point < leaf_.points.size(); ++point) {
            at_point(corners_at(point));
        }
        std::vector<CornerId> tips;
        for (std::size_t point = 0; point < leaf_.points.size(); ++point) {
            const std::span<const CornerId> about = corners_at(point);
            if (is_tip(about)) {
                tips.insert(tips.end(), about.begin(), about.end());
            }
        }
        for (const CornerId c : tips) {
            normals_[c / 3][c % 3] = glm::dvec3(0);
        }
        return std::move(normals_);
    }

  private:
    void measure_facets() {
        facets_.resize(leaf_.triangles.size());
        angles_.resize(leaf_.triangles.size());
        for (std::size_t t = 0; t < facets_.size(); ++t) {
            if (!curved(t)) {
                continue;
            }
            std::array<glm::dvec3, 3> sides{};
            for (int i = 0; i < 3; ++i) {
                sides[static_cast<std::size_t>(i)] = direction(point(t, (i + 1) % 3) - point(t, i));
            }
            facets_[t] = direction(glm::cross(sides[0], sides[1]));
            if (facets_[t] == glm::dvec3(0)) {
                continue;  // It has no area, and no say.
            }
            for (std::size_t i = 0; i < 3; ++i) {
                angles_[t][i] = angle(sides[i], -sides[(i + 2) % 3]);
            }
        }
    }

    void gather_corners() {
        first_.assign(leaf_.points.size() + 1, 0);
        for_each_corner([&](CornerId, std::uint32_t p) { ++first_[p + 1]; });
        for (std::size_t p = 1; p < first_.size(); ++p) {
            first_[p] += first_[p - 1];
        }
        corners_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for_each_corner([&](CornerId c, std::uint32_t p) { corners_[next[p]++] = c; });
    }

    template <typename Visit>
    void for_each_corner(const Visit& visit) const {
        for (std::size_t t = 0; t < leaf_.triangles.size(); ++t) {
            if (curved(t)) {
                for (int i = 0; i < 3; ++i) {
                    visit(static_cast<CornerId>(3 * t) + static_cast<CornerId>(i), leaf_.triangles[t][i]);
                }
            }
        }
    }

    void at_point(std::span<const CornerId> about) {
        if (about.empty()) {
            return;
        }
        const FacetGroup first = groups_[about[0] / 3];
        const bool one = std::all_of(about.begin(), about.end(), [&](CornerId c) {
            return groups_[c / 3].surface() == first.surface() && groups_[c / 3].stretch() == first.stretch();
        });
        const glm::dvec3 all = one ? mean(about, first) : glm::dvec3(0);
        for (const CornerId c : about) {
            normals_[c / 3][c % 3] = one ? all : mean(about, groups_[c / 3]);
        }
    }

    [[nodiscard]] glm::dvec3 mean(std::span<const CornerId> about, FacetGroup group) const {
        glm::dvec3 sum(0);
        for (const CornerId c : about) {
            if (smooth_between(groups_[c / 3], group)) {
                sum += angles_[c / 3][c % 3] * facets_[c / 3];
            }
        }
        return direction(sum);
    }

    /// Of facets of one surface all around a point.
    [[nodiscard]] bool is_tip(std::span<const CornerId> about) const {
        if (about.size() < 3) {
            return false;
        }
        const glm::dvec3 axis = normals_[about[0] / 3][about[0] % 3];
        double facets = 1, corners = 1;  // Cosines of the largest angles.
        std::uint32_t ring = 0;          // Each corner about a point inside of a surface is of two of the triangles.
        for (const CornerId c : about) {
            if (!smooth_between(groups_[c / 3], groups_[about[0] / 3])) {
                return false;
            }
            facets = std::min(facets, glm::dot(axis, facets_[c / 3]));
            for (const CornerId other : {(c + 1) % 3, (c + 2) % 3}) {
                corners = std::min(corners, glm::dot(axis, normals_[c / 3][other]));
            }
            ring += leaf_.triangles[c / 3][static_cast<int>((c + 1) % 3)];
            ring -= leaf_.triangles[c / 3][static_cast<int>((c + 2) % 3)];
        }
        return ring == 0 && facets < kFlatTip &&
               std::acos(std::max(corners, -1.0)) < kPole * std::acos(std::max(facets, -1.0));
    }

    [[nodiscard]] bool curved(std::size_t triangle) const { return curved_.contains(groups_[triangle].surface()); }
    [[nodiscard]] const glm::dvec3& point(std::size_t triangle, int corner) const {
        return leaf_.points[leaf_.triangles[triangle][corner]];
    }
    [[nodiscard]] std::span<const CornerId> corners_at(std::size_t point) const {
        return std::span(corners_).subspan(first_[point], first_[point + 1] - first_[point]);
    }

    const PlacedLeaf& leaf_;
    std::span<const FacetGroup> groups_;
    std::unordered_set<std::uint32_t> curved_;  ///< Surfaces.
    std::vector<glm::dvec3> facets_;            ///< By triangle: normals.
    std::vector<std::array<double, 3>> angles_;
    std::vector<std::uint32_t> first_;  ///< By point, among the corners.
    std::vector<CornerId> corners_;
    std::vector<CornerNormals> normals_;
};

}  // namespace

std::vector<CornerNormals> corner_normals(const PlacedLeaf& leaf) {
    const std::span<const FacetGroup> groups = groups_of(leaf);
    if (groups.empty() || leaf.triangles.empty()) {
        return {};
    }
    Normals normals(leaf, groups);
    return normals.none() ? std::vector<CornerNormals>() : normals.find();
}

}  // namespace csg::solid
