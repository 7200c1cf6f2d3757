#include "csg/solid/trim_leaves.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "csg/solid/edge_crossings.h"
#include "csg/solid/no_index.h"
#include "csg/solid/place_leaf.h"
#include "csg/solid/used_points.h"

namespace csg::solid {
namespace {

/// Of the faces of cuts, which nobody sees.
const FacetGroup kCut(FacetGroup::kSurfaces - 1);

/// The points p with sign * p[axis] <= bound.
struct Half {
    int axis;
    double sign, bound;
    [[nodiscard]] double depth(const glm::dvec3& p) const { return bound - sign * p[axis]; }
};

std::vector<double> depths_of(std::span<const glm::dvec3> points, const Half& half) {
    std::vector<double> depths;
    for (const glm::dvec3& p : points) {
        depths.push_back(half.depth(p));
    }
    return depths;
}

/// Cuts a closed mesh and closes the cut.
class Cutter {
  public:
    Cutter(PlacedLeaf& leaf, const Half& half)
        : leaf_(leaf), half_(half), crossings_(leaf.points, depths_of(leaf.points, half)) {}

    void cut() {
        const std::span<const FacetGroup> groups = groups_of(leaf_);
        for (std::size_t i = 0; i < leaf_.triangles.size(); ++i) {
            group_ = groups.empty() ? kCut : groups[i];
            cut(leaf_.triangles[i]);
        }
        leaf_.triangles = std::move(kept_);
        leaf_.groups = std::move(kept_groups_);
    }

  private:
    void cut(const glm::uvec3& t) {
        std::array<std::uint32_t, 4> polygon{};
        std::size_t count = 0;
        std::uint32_t leaving = kNone, entering = kNone;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t p = t[i], q = t[(i + 1) % 3];
            const bool from_inside = crossings_.inside(p), to_inside = crossings_.inside(q);
            if (from_inside) {
                polygon[count++] = p;
            }
            if (from_inside && !to_inside) {
                leaving = polygon[count++] = crossing(p, q);
            } else if (!from_inside && to_inside) {
                entering = polygon[count++] = crossing(q, p);
            }
        }
        for (std::size_t i = 2; i < count; ++i) {
            add(polygon[0], polygon[i - 1], polygon[i]);
        }
        if (leaving == kNone || leaving == entering) {
            return;
        }
        if (apex_ == kNone) {
            apex_ = leaving;
        }
        group_ = kCut;
        add(apex_, entering, leaving);
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) {
            kept_.emplace_back(a, b, c);
            kept_groups_.push_back(group_);
        }
    }

    /// Exactly in the plane.
    std::uint32_t crossing(std::uint32_t in, std::uint32_t out) {
        const std::uint32_t at = crossings_.crossing(in, out);
        if (at != in) {
            leaf_.points[at][half_.axis] = half_.sign * half_.bound;
        }
        return at;
    }

    PlacedLeaf& leaf_;
    Half half_;
    EdgeCrossings crossings_;
    std::vector<glm::uvec3> kept_;
    std::vector<FacetGroup> kept_groups_;
    FacetGroup group_;  ///< Of what is cut.
    std::uint32_t apex_ = kNone;
};

}  // namespace

void trim_leaf(PlacedLeaf& leaf, const Box& limit) {
    bool cut = false;
    for (int axis = 0; axis < 3; ++axis) {
        for (const Half& half : {Half{axis, 1, limit.hi[axis]}, Half{axis, -1, -limit.lo[axis]}}) {
            const double farthest = half.sign > 0 ? leaf.box.hi[axis] : -leaf.box.lo[axis];
            if (farthest > half.bound) {
                Cutter(leaf, half).cut();
                cut = true;
            }
        }
    }
    if (!cut) {
        return;
    }
    leaf.points = used_points(leaf.points, leaf.triangles);
    leaf.box = {};
    for (const glm::dvec3& p : leaf.points) {
        leaf.box = enclose(leaf.box, p);
    }
    if (!has_volume(leaf.box)) {  // It only touched what it was cut to.
        leave_out(leaf);
    }
}

std::optional<Box> trim_limit(const Scene& scene, const Part& part, std::span<const Box> boxes) {
    const Box box = bounds(scene, part, boxes);
    const double reach = kFarthestReach * box.diagonal();
    return reach > 0 ? std::optional(Box{box.lo - reach, box.hi + reach}) : std::nullopt;
}

void trim_leaves(const Scene& scene, std::span<PlacedLeaf> leaves) {
    std::vector<Box> boxes;
    for (const PlacedLeaf& leaf : leaves) {
        boxes.push_back(leaf.box);
    }
    for (const Part& part : scene.parts) {
        const std::optional<Box> limit = trim_limit(scene, part, boxes);
        for (PlacedLeaf& leaf : leaves.subspan(part.first_leaf, part.leaf_count)) {
            if (limit && !leaf.box.empty() && leaf.solid->closed) {
                trim_leaf(leaf, *limit);
            }
        }
    }
}

}  // namespace csg::solid
