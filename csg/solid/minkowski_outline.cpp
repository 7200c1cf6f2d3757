// The Minkowski sum of regions: what the edges of one sweep along the edges of the other, and each region where the
// other's components begin. A point of the sum that no pair of edges reaches has a whole component of one region around
// every point of a component of the other.
#include "csg/solid/outline.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostPairs = std::size_t{1} << 22;

Loop moved(const Loop& loop, const glm::dvec2& by) {
    Loop result(loop);
    for (glm::dvec2& p : result) {
        p += by;
    }
    return result;
}

/// The parallelograms of all pairs of edges, all counter-clockwise.
std::vector<Loop> sweeps(const Outline& a, const Outline& b) {
    std::vector<Loop> result;
    for (const Loop& p : a.loops) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec2 &p0 = p[i], &p1 = p[(i + 1) % p.size()];
            for (const Loop& q : b.loops) {
                for (std::size_t j = 0; j < q.size(); ++j) {
                    const glm::dvec2 &q0 = q[j], &q1 = q[(j + 1) % q.size()];
                    const glm::dvec2 u = p1 - p0, v = q1 - q0;
                    if (u.x * v.y - u.y * v.x > 0) {
                        result.push_back({p0 + q0, p1 + q0, p1 + q1, p0 + q1});
                    } else {
                        result.push_back({p0 + q0, p0 + q1, p1 + q1, p1 + q0});
                    }
                }
            }
        }
    }
    return result;
}

}  // namespace

Outline minkowski(const Outline& a, const Outline& b) {
    if (a.empty() || b.empty()) {
        return {};
    }
    if (a.corners() * b.corners() > kMostPairs) {
        throw OutlineError("minkowski() of outlines with more than 4194304 pairs of edges");
    }
    std::vector<std::shared_ptr<const Outline>> all{std::make_shared<Outline>(clean(sweeps(a, b), FillRule::NonZero))};
    const auto place = [&](const Outline& region, const Outline& where) {
        for (const Loop& component : where.loops) {
            if (area2(component) < 0) {
                continue;
            }
            auto copy = std::make_shared<Outline>();
            for (const Loop& loop : region.loops) {
                copy->loops.push_back(moved(loop, component[0]));
            }
            all.push_back(std::move(copy));
        }
    };
    place(a, b);
    place(b, a);
    return combine(BooleanKind::Union, all);
}

}  // namespace csg::solid
