#include "csg/reference/simple_prism.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"

namespace csg::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Side = std::pair<std::uint32_t, std::uint32_t>;

class Prism {
  public:
    Prism(const Mesh& mesh, int axis) : mesh_(mesh), axis_(axis) {
        lo_ = hi_ = mesh.points[0][axis];
        for (const glm::dvec3& p : mesh.points) {
            lo_ = std::min(lo_, p[axis]);
            hi_ = std::max(hi_, p[axis]);
        }
    }

    /// False where it is none.
    bool find() {
        return std::all_of(mesh_.points.begin(), mesh_.points.end(),
                           [&](const glm::dvec3& p) { return p[axis_] == lo_ || p[axis_] == hi_; }) &&
               find_corners() && find_sides();
    }

    [[nodiscard]] bool sides_meet(const std::stop_token& stop) const {
        std::vector<Box> boxes;
        boxes.reserve(sides_.size());
        for (const auto& [a, b] : sides_) {
            boxes.push_back(enclose(enclose(Box(), glm::dvec3(corners_[a], 0.0)), glm::dvec3(corners_[b], 0.0)));
        }
        base::PacedStop paced(stop);
        bool found = false;
        BoxTree(boxes).pairs([&](std::uint32_t i, std::uint32_t j) {
            paced();
            found = found || meet(sides_[i], sides_[j]);
        });
        return found;
    }

  private:
    [[nodiscard]] glm::dvec2 seen(const glm::dvec3& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }
    [[nodiscard]] bool is_high(std::uint32_t point) const { return mesh_.points[point][axis_] == hi_; }

    /// Each corner has one point below and one above.
    bool find_corners() {
        std::vector<std::uint32_t> order(mesh_.points.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto key = [&](std::uint32_t i) {
            const glm::dvec2 at = seen(mesh_.points[i]);
            return std::array<double, 3>{at.x, at.y, mesh_.points[i][axis_]};
        };
        std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
        if (order.size() % 2 != 0) {
            return false;
        }
        corner_of_.resize(order.size());
        for (std::size_t i = 0; i < order.size(); i += 2) {
            const glm::dvec2 at = seen(mesh_.points[order[i]]);
            if (at != seen(mesh_.points[order[i + 1]]) || is_high(order[i]) || !is_high(order[i + 1]) ||
                (!corners_.empty() && corners_.back() == at)) {
                return false;
            }
            corner_of_[order[i]] = corner_of_[order[i + 1]] = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back(at);
        }
        return true;
    }

    /// Faces look up above and down below; each side is two triangles, and two sides end at each corner.
    bool find_sides() {
        for (const glm::uvec3& t : mesh_.triangles) {
            const int high =
                static_cast<int>(is_high(t.x)) + static_cast<int>(is_high(t.y)) + static_cast<int>(is_high(t.z));
            std::array<std::uint32_t, 3> c{corner_of_[t.x], corner_of_[t.y], corner_of_[t.z]};
            if (high == 0 || high == 3) {
                if (turn(c[0], c[1], c[2]) != (high == 3 ? 1 : -1)) {
                    return false;
                }
                continue;
            }
            std::sort(c.begin(), c.end());
            if (c[0] != c[1] && c[1] != c[2]) {
                return false;
            }
            sides_.emplace_back(c[0], c[2]);
        }
        std::sort(sides_.begin(), sides_.end());
        std::vector<Side> once;
        std::vector<int> ends(corners_.size(), 0);
        for (std::size_t i = 0; i < sides_.size(); i += 2) {
            if (i + 1 == sides_.size() || sides_[i] != sides_[i + 1] || (!once.empty() && once.back() == sides_[i])) {
                return false;
            }
            once.push_back(sides_[i]);
            ++ends[sides_[i].first];
            ++ends[sides_[i].second];
        }
        sides_ = std::move(once);
        return std::all_of(ends.begin(), ends.end(), [](int count) { return count == 2; });
    }

    [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const auto at = [&](std::uint32_t i) { return Kernel::Point_2(corners_[i].x, corners_[i].y); };
        return CGAL::orientation(at(a), at(b), at(c));
    }

    /// Of sides whose boxes meet: anywhere but in a common end?
    [[nodiscard]] bool meet(const Side& s, const Side& t) const {
        for (const auto& [end, other] : {s, Side(s.second, s.first)}) {
            if (end == t.first || end == t.second) {
                const std::uint32_t beyond = end == t.first ? t.second : t.first;
                return turn(end, other, beyond) == 0 && same_way(corners_[end], corners_[other], corners_[beyond]);
            }
        }
        return turn(s.first, s.second, t.first) * turn(s.first, s.second, t.second) <= 0 &&
               turn(t.first, t.second, s.first) * turn(t.first, t.second, s.second) <= 0;
    }

    /// Of points on a line through `from`.
    static bool same_way(const glm::dvec2& from, const glm::dvec2& a, const glm::dvec2& b) {
        return a.x != from.x ? (a.x > from.x) == (b.x > from.x) : (a.y > from.y) == (b.y > from.y);
    }

    const Mesh& mesh_;
    int axis_;
    double lo_ = 0, hi_ = 0;
    std::vector<glm::dvec2> corners_;
    std::vector<std::uint32_t> corner_of_;  ///< By point.
    std::vector<Side> sides_;
};

}  // namespace

std::optional<bool> prism_meets_itself(const Mesh& mesh, const std::stop_token& stop) {
    for (const int axis : {2, 0, 1}) {
        if (Prism prism(mesh, axis); prism.find()) {
            return prism.sides_meet(stop);
        }
    }
    return {};
}

}  // namespace csg::reference
