#include "csg/solid/region_loops.h"

#include <numeric>
#include <tuple>

#include "csg/solid/outline.h"
#include "csg/solid/plane_sweep.h"

namespace csg::solid {
namespace {

/// An edge with the region to its left.
struct Side {
    GridPoint from, to;
    auto operator<=>(const Side&) const = default;
};

std::vector<Side> sides(std::span<const GridEdge> edges, const Inside& inside) {
    struct Winding {
        int first = 0, second = 0;
    };
    std::vector<Winding> above(edges.size());
    std::vector<Side> result;
    const bool planar = sweep(edges, [&](const SweepVertex& vertex) {
        Winding winding = vertex.below == kNoEdge ? Winding{} : above[vertex.below];
        for (const std::uint32_t e : vertex.right) {
            const bool before = inside(winding.first, winding.second);
            winding.first += edges[e].weight;
            winding.second += edges[e].other;
            above[e] = winding;
            const bool after = inside(winding.first, winding.second);
            if (before != after) {
                result.push_back(after ? Side{edges[e].a, edges[e].b} : Side{edges[e].b, edges[e].a});
            }
        }
        return true;
    });
    if (!planar) {
        throw OutlineError("outlines that cross each other in a way that cannot be resolved");
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// Is `p` met before `q`, clockwise from direction `from`?
bool comes_first(const GridPoint& from, const GridPoint& p, const GridPoint& q) {
    const auto half = [&](const GridPoint& way) {
        const int side = sign(cross(from, way));
        return side < 0 ? 0 : side > 0 ? 2 : 1;
    };
    return half(p) != half(q) ? half(p) < half(q) : cross(p, q) < 0;
}

/// Walks along the region: at each point it turns as far to the left as it can, so that what meets in a point only is
/// apart; a way that comes back to one of its points leaves a loop behind there, so that no loop touches itself.
class Walk {
  public:
    explicit Walk(std::vector<Side> sides) : sides_(std::move(sides)), used_(sides_.size(), 0) {
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            if (i == 0 || sides_[i].from != sides_[i - 1].from) {
                begin_.push_back(i);
            }
            vertex_.push_back(begin_.size() - 1);
        }
        begin_.push_back(sides_.size());
        on_way_.assign(begin_.size(), kNone);
    }

    std::vector<GridLoop> loops() {
        for (std::size_t first = 0; first < sides_.size(); ++first) {
            for (std::size_t at = first; used_[at] == 0; at = next(at)) {
                used_[at] = 1;
                on_way_[vertex_[at]] = way_.size();
                way_.push_back(at);
                if (const std::size_t back = on_way_[vertex_of(sides_[at].to)]; back != kNone) {
                    leave(back);
                }
            }
        }
        std::sort(result_.begin(), result_.end());
        return std::move(result_);
    }

  private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    [[nodiscard]] std::size_t vertex_of(const GridPoint& p) const {
        const auto side = std::lower_bound(sides_.begin(), sides_.end(), p,
                                           [](const Side& s, const GridPoint& q) { return s.from < q; });
        return vertex_[static_cast<std::size_t>(side - sides_.begin())];
    }
    [[nodiscard]] std::size_t next(std::size_t at) const {
        const std::size_t vertex = vertex_of(sides_[at].to);
        std::size_t best = begin_[vertex];
        const GridPoint &here = sides_[at].to, back = sides_[at].from - here;
        for (std::size_t i = best + 1; i < begin_[vertex + 1]; ++i) {
            if (comes_first(back, sides_[i].to - here, sides_[best].to - here)) {
                best = i;
            }
        }
        return best;
    }
    /// What lies on the way from `back` on is a loop.
    void leave(std::size_t back) {
        GridLoop loop;
        const std::size_t n = way_.size() - back;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t before = way_[back + (i + n - 1) % n], at = way_[back + i];
            const bool alone = begin_[vertex_[at] + 1] - begin_[vertex_[at]] == 1;
            if (!alone || turn_sign(sides_[before].from, sides_[at].from, sides_[at].to) != 0) {
                loop.push_back(sides_[at].from);
            }
            on_way_[vertex_[at]] = kNone;
        }
        way_.resize(back);
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        result_.push_back(std::move(loop));
    }

    std::vector<Side> sides_;
    std::vector<char> used_;
    std::vector<std::size_t> begin_, vertex_;  ///< Of the sides from each point; the number of each side's point.
    std::vector<std::size_t> way_, on_way_;    ///< Sides; where on the way each point is.
    std::vector<GridLoop> result_;
};

}  // namespace

std::vector<GridLoop> boundary(std::span<const GridEdge> arranged, const Inside& inside) {
    return Walk(sides(arranged, inside)).loops();
}

}  // namespace csg::solid
