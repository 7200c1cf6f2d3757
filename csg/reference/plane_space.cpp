#include "csg/reference/plane_space.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace csg::reference {

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
        const glm::dvec3 normal = content_.planes[cells[s.cell].plane].plane.normal;
        const glm::dvec3 into = glm::cross(normal, along) * (s.left ? 1.0 : -1.0);
        sorted.push_back({std::atan2(glm::dot(into, y), glm::dot(into, x)), s});
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const Angle& p, const Angle& q) { return p.angle < q.angle; });
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i > 0 && sorted[i].angle - sorted[i - 1].angle < 1e-9) {
            throw Undecided("two faces meet at an edge at no angle");
        }
        sides[i] = sorted[i].side;
    }
}

std::optional<Covers> PlaneSpace::windings_above(const ComplexCell& cell) const {
    const auto area = [&](const glm::uvec3& t) {
        return glm::length(glm::cross(points_[t.y] - points_[t.x], points_[t.z] - points_[t.x]));
    };
    const glm::uvec3 t = *std::max_element(cell.triangles.begin(), cell.triangles.end(),
                                           [&](const auto& a, const auto& b) { return area(a) < area(b); });
    const PlaneContent& plane = content_.planes[cell.plane];
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int attempt = 0; attempt < 64; ++attempt) {
        const double u = 0.2 + 0.3 * number(), v = 0.2 + 0.3 * number();
        const glm::dvec3 origin = points_[t.x] * (1 - u - v) + points_[t.y] * u + points_[t.z] * v;
        const double a = number(), b = number(), c = number();
        const glm::dvec3 aside(a - 0.5, b - 0.5, c - 0.5);
        if (auto found = probe_.windings(origin, glm::normalize(plane.plane.normal + aside), plane.index)) {
            return found;
        }
    }
    return {};
}

}  // namespace csg::reference
