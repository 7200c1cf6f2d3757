#include "csg/solid/trim_leaves.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace csg::solid {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The points p with sign * p[axis] <= bound.
struct Half {
    int axis;
    double sign, bound;
    [[nodiscard]] double depth(const glm::dvec3& p) const { return bound - sign * p[axis]; }
};

/// Cuts a closed mesh and closes the cut.
class Cutter {
  public:
    Cutter(PlacedLeaf& leaf, const Half& half) : leaf_(leaf), half_(half) {
        for (const glm::dvec3& p : leaf.points) {
            depths_.push_back(half.depth(p));
        }
    }

    void cut() {
        for (const glm::uvec3& t : leaf_.triangles) {
            cut(t);
        }
        leaf_.triangles = std::move(kept_);
    }

  private:
    [[nodiscard]] bool inside(std::uint32_t p) const { return depths_[p] >= 0; }

    void cut(const glm::uvec3& t) {
        std::array<std::uint32_t, 4> polygon{};
        std::size_t count = 0;
        std::uint32_t leaving = kNone, entering = kNone;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t p = t[i], q = t[(i + 1) % 3];
            if (inside(p)) {
                polygon[count++] = p;
            }
            if (inside(p) && !inside(q)) {
                leaving = polygon[count++] = crossing(p, q);
            } else if (!inside(p) && inside(q)) {
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
        add(apex_, entering, leaving);
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) {
            kept_.emplace_back(a, b, c);
        }
    }

    /// The point where an edge leaves: one for both triangles that share the edge.
    std::uint32_t crossing(std::uint32_t in, std::uint32_t out) {
        if (depths_[in] == 0) {
            return in;
        }
        const auto [at, is_new] = crossings_.try_emplace({in, out}, static_cast<std::uint32_t>(leaf_.points.size()));
        if (is_new) {
            const glm::dvec3 p = leaf_.points[in], q = leaf_.points[out];
            glm::dvec3 middle = p + (q - p) * (depths_[in] / (depths_[in] - depths_[out]));
            middle[half_.axis] = half_.sign * half_.bound;
            leaf_.points.push_back(middle);
        }
        return at->second;
    }

    PlacedLeaf& leaf_;
    Half half_;
    std::vector<double> depths_;  ///< Of the points before the cut.
    std::vector<glm::uvec3> kept_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
    std::uint32_t apex_ = kNone;
};

/// Leaves out points that no triangle has, and measures the box again.
void compact(PlacedLeaf& leaf) {
    std::vector<std::uint32_t> place(leaf.points.size(), kNone);
    std::vector<glm::dvec3> points;
    leaf.box = {};
    for (glm::uvec3& t : leaf.triangles) {
        for (int i = 0; i < 3; ++i) {
            std::uint32_t& at = place[t[i]];
            if (at == kNone) {
                at = static_cast<std::uint32_t>(points.size());
                points.push_back(leaf.points[t[i]]);
                leaf.box = enclose(leaf.box, points.back());
            }
            t[i] = at;
        }
    }
    leaf.points = std::move(points);
}

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
    compact(leaf);
    const glm::dvec3 size = leaf.box.size();
    if (leaf.box.empty() || std::min({size.x, size.y, size.z}) <= 0) {  // It only touched what it was cut to.
        leaf.points.clear();
        leaf.triangles.clear();
        leaf.box = {};
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
