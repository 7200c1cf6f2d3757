#include "csg/reference/plane_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace csg::reference {
namespace {

/// Where a ray meets leaves, in double precision: rays that pass an edge closely are refused.
class RayProbe {
  public:
    RayProbe(const solid::Geometry& geometry, std::span<const LeafId> leaves) : geometry_(geometry), leaves_(leaves) {}

    /// How often the leaves wind around the points just beyond `origin` in `direction`, faces on plane `without` not
    /// counted (the origin is on it). Nothing where the ray is too near to an edge to tell.
    std::optional<Covers> windings(const glm::dvec3& origin, const glm::dvec3& direction, std::uint32_t without) const {
        Covers result;
        for (const LeafId id : leaves_) {
            const solid::PlacedLeaf& leaf = geometry_.leaves[id];
            if (!meets(leaf.box, origin, direction))
                continue;
            std::int32_t count = 0;
            for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
                if (leaf.planes[t].index == without)
                    continue;
                const std::optional<int> hit = crosses(leaf, leaf.triangles[t], origin, direction);
                if (!hit)
                    return {};
                count += *hit;
            }
            if (count != 0)
                result.push_back({id, count});
        }
        return result;
    }

  private:
    static bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& direction) {
        double from = 0, to = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const double margin = 1e-6 * (box.hi[axis] - box.lo[axis]);
            const double a = (box.lo[axis] - margin - origin[axis]) / direction[axis];
            const double b = (box.hi[axis] + margin - origin[axis]) / direction[axis];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return from <= to;
    }

    /// 1: from behind the triangle, -1: from in front of it, 0: not at all. Nothing where it cannot be told.
    static std::optional<int> crosses(const solid::PlacedLeaf& leaf, const glm::uvec3& t, const glm::dvec3& o,
                                      const glm::dvec3& d) {
        const glm::dvec3 a = leaf.points[t.x] - o, b = leaf.points[t.y] - o, c = leaf.points[t.z] - o;
        const glm::dvec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
        const double u = glm::dot(d, bc), v = glm::dot(d, ca), w = glm::dot(d, ab);
        // Relative to the sizes that cancel in each of them.
        const double scale = 1e-11 * std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
        if ((u > scale && v < -scale) || (v > scale && w < -scale) || (w > scale && u < -scale) ||
            (u < -scale && v > scale) || (v < -scale && w > scale) || (w < -scale && u > scale))
            return 0;
        const double volume = glm::dot(a, bc);
        if (std::abs(u) <= scale || std::abs(v) <= scale || std::abs(w) <= scale) {
            // Beside an edge; behind the origin it does not matter.
            if (volume * (u + v + w) < 0 && std::abs(volume) > scale * 1e-3)
                return 0;
            return {};
        }
        const bool outwards = u + v + w > 0;
        if ((volume > 0) != outwards)
            return 0;
        return outwards ? 1 : -1;
    }

    const solid::Geometry& geometry_;
    std::span<const LeafId> leaves_;
};

}  // namespace

void PlaneSpace::sort_around(std::span<ComplexSide> sides, std::span<const ComplexCell> cells) const {
    struct Angle {
        double angle;
        ComplexSide side;
    };
    const glm::dvec3 along = points_[sides[0].hi] - points_[sides[0].lo];
    const glm::dvec3 a = glm::abs(along);
    const glm::dvec3 helper = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                              : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                       : glm::dvec3(0, 0, 1);
    const glm::dvec3 x = glm::normalize(glm::cross(along, helper));
    const glm::dvec3 y = glm::normalize(glm::cross(along, x));
    std::vector<Angle> sorted;
    sorted.reserve(sides.size());
    for (const ComplexSide& s : sides) {
        const glm::dvec3 normal = geometry_.planes.planes()[cells[s.cell].plane].normal;
        const glm::dvec3 into = glm::cross(normal, along) * (s.left ? 1.0 : -1.0);
        sorted.push_back({std::atan2(glm::dot(into, y), glm::dot(into, x)), s});
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const Angle& p, const Angle& q) { return p.angle < q.angle; });
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i > 0 && sorted[i].angle - sorted[i - 1].angle < 1e-9)
            throw Undecided("two faces meet at an edge at no angle");
        sides[i] = sorted[i].side;
    }
}

Covers PlaneSpace::windings_above(const ComplexCell& cell) const {
    const auto area = [&](const glm::uvec3& t) {
        return glm::length(glm::cross(points_[t.y] - points_[t.x], points_[t.z] - points_[t.x]));
    };
    const glm::uvec3 t = *std::max_element(cell.triangles.begin(), cell.triangles.end(),
                                           [&](const auto& a, const auto& b) { return area(a) < area(b); });
    const glm::dvec3 normal = geometry_.planes.planes()[cell.plane].normal;
    const RayProbe ray(geometry_, leaves_);
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int attempt = 0; attempt < 64; ++attempt) {
        const double u = 0.2 + 0.3 * number(), v = 0.2 + 0.3 * number();
        const glm::dvec3 origin = points_[t.x] * (1 - u - v) + points_[t.y] * u + points_[t.z] * v;
        const double a = number(), b = number(), c = number();
        const glm::dvec3 aside(a - 0.5, b - 0.5, c - 0.5);
        if (const auto found = ray.windings(origin, glm::normalize(normal + aside), cell.plane))
            return *found;
    }
    throw Undecided("no ray from a face tells what is in front of it");
}

}  // namespace csg::reference
