#include "csg/reference/minkowski.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/stop.h"
#include "csg/reference/components.h"
#include "csg/reference/convex_cover.h"
#include "csg/reference/convex_union.h"
#include "csg/reference/convolution_sum.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/solid/plane_table.h"

namespace csg::reference {
namespace {

/// Corners of all hulls together: some gigabytes.
constexpr std::size_t kMostCorners = std::size_t{1} << 23;

/// More hulls than these are made fewer, by growing pieces where these are not more than so many.
constexpr std::size_t kManyHulls = 64, kMostGrown = 4096;

void check_cost(const ConvexCover& a, const ConvexCover& b) {
    std::size_t corners = 0;
    for (const Convex& p : a.pieces) {
        for (const Convex& q : b.pieces) {
            corners += std::min(p.points().size() * q.points().size(), 2 * (p.points().size() + q.points().size()));
        }
        if (corners > kMostCorners) {
            throw std::runtime_error(fmt::format("minkowski() would need {} hulls, with more than {} corners together",
                                                 a.pieces.size() * b.pieces.size(), kMostCorners));
        }
    }
}

/// Does the sum hold the point, which is in none of the hulls? Then one of the solids, moved there, holds a whole
/// component of the other.
bool holds(const ConvexCover& a, const ConvexCover& b, const glm::dvec3& point, const std::stop_token& stop) {
    const auto in = [&](const ConvexCover& solid, const ConvexCover& other) {
        return std::any_of(other.points.begin(), other.points.end(), [&](const glm::dvec3& p) {
            base::end_if_asked(stop);
            return solid.holds(point - p);
        });
    };
    return in(a, b) || in(b, a);
}

/// Closes the holes that belong to the sum: without the components of the surface that have the sum before them, too.
Mesh without_false_holes(const Mesh& hulls, const ConvexCover& a, const ConvexCover& b, const std::stop_token& stop) {
    const std::vector<Mesh> components = components_of(hulls);
    if (components.size() == 1) {
        return hulls;
    }
    const double distance = 64 * solid::coincidence_tolerance(facts(hulls).box.diagonal());
    Mesh result;
    for (const Mesh& component : components) {
        if (holds(a, b, before(component, distance), stop)) {
            continue;
        }
        const auto first = static_cast<std::uint32_t>(result.points.size());
        result.points.insert(result.points.end(), component.points.begin(), component.points.end());
        for (const glm::uvec3& t : component.triangles) {
            result.triangles.push_back(t + first);
        }
    }
    return result;
}

Mesh sum_of_pieces(const ConvexCover& a, const ConvexCover& b, const std::stop_token& stop) {
    check_cost(a, b);
    std::vector<Mesh> hulls;
    for (const Convex& p : a.pieces) {
        for (const Convex& q : b.pieces) {
            base::end_if_asked(stop);
            if (Mesh sum = sum_of_convex(p, q, stop); !sum.empty()) {
                hulls.push_back(std::move(sum));
            }
        }
    }
    if (hulls.size() == 1) {
        return std::move(hulls[0]);
    }
    return without_false_holes(union_of_convex(hulls, stop), a, b, stop);
}

/// Has it faces for pieces?
bool has_polygons(const ConvexCover& cover) {
    return std::any_of(cover.pieces.begin(), cover.pieces.end(), [](const Convex& p) { return p.triangles().empty(); });
}

Mesh sum_of(ConvexCover a, ConvexCover b, const std::stop_token& stop) {
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        if (one->convex && has_polygons(*other)) {
            if (std::optional<Mesh> sum = convolution_sum(other->meshes, one->pieces[0], stop)) {
                return std::move(*sum);
            }
        }
    }
    const auto grow_both = [&] {
        for (ConvexCover* cover : {&a, &b}) {
            if (cover->pieces.size() > 1 && cover->pieces.size() <= kMostGrown) {
                grow(*cover, stop);
            }
        }
    };
    // Larger pieces are worth their making where both are many.
    const bool many = std::min(a.pieces.size(), b.pieces.size()) > 1 && a.pieces.size() * b.pieces.size() > kManyHulls;
    if (many) {
        grow_both();
    }
    try {
        return sum_of_pieces(a, b, stop);
    } catch (const std::runtime_error&) {
        // Other pieces give other hulls, which may be united where these are too near to degenerate.
        if (many) {
            throw;
        }
        grow_both();
        return sum_of_pieces(a, b, stop);
    }
}

}  // namespace

Mesh minkowski_sum(std::span<const std::vector<Mesh>> operands, const std::stop_token& stop) {
    std::vector<ConvexCover> covers;
    for (const std::vector<Mesh>& operand : operands) {
        if (ConvexCover cover = convex_cover(operand, stop); !cover.pieces.empty()) {
            covers.push_back(std::move(cover));
        }
    }
    if (covers.empty()) {
        return {};
    }
    // What is convex stays convex when it is summed.
    std::stable_partition(covers.begin(), covers.end(), [](const ConvexCover& cover) { return cover.convex; });
    Mesh sum;
    if (covers.size() == 1) {
        sum = covers[0].meshes.size() == 1 ? std::move(covers[0].meshes[0])
                                           : combine(ExpressionKind::Union, covers[0].meshes, stop).mesh;
    }
    for (std::size_t i = 1; i < covers.size(); ++i) {
        sum = sum_of(i == 1 ? std::move(covers[0]) : convex_cover({std::move(sum)}, stop), std::move(covers[i]), stop);
    }
    sum.sources.assign(sum.triangles.size(), 0);
    return sum;
}

Mesh minkowski_sum(std::span<const Mesh> operands, const std::stop_token& stop) {
    std::vector<std::vector<Mesh>> unions;
    for (const Mesh& operand : operands) {
        unions.push_back({operand});
    }
    return minkowski_sum(unions, stop);
}

}  // namespace csg::reference
