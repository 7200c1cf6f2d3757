// Between two edges of the sweep that have the region between them, the border of what has its triangles already is a
// chain of points, bottom to top, in which no corner looks forward: each new point takes away what it sees of it.
#include "csg/solid/sweep_triangulation.h"

#include "csg/solid/indexed_outline.h"
#include "csg/solid/no_index.h"
#include "csg/solid/plane_sweep.h"

namespace csg::solid {
namespace {

struct Link {
    std::uint32_t point, down = kNone, up = kNone;
};

struct Chain {
    std::uint32_t low = kNone, high = kNone;
    std::uint32_t newest = kNone;  ///< From here everything ahead is seen up to the next point.
};

class Sweeper {
  public:
    Sweeper(std::span<const GridPoint> points, const LoopEdges& edges)
        : points_(points), edges_(edges), chains_(edges.edges.size()) {}

    bool run() {
        return sweep(edges_.edges, [&](const SweepVertex& vertex) { return visit(vertex); });
    }
    std::vector<glm::uvec3> triangles;

  private:
    [[nodiscard]] bool inside_above(std::uint32_t e) const { return e != kNoEdge && edges_.edges[e].weight > 0; }

    bool visit(const SweepVertex& vertex) {
        const auto left = vertex.left, right = vertex.right;
        const std::uint32_t v = left.empty() ? edges_.from[right[0]] : edges_.to[left[0]];
        bool inside = inside_above(vertex.below);
        Chain above;  // Of what goes on above the point.
        if (left.empty()) {
            if (inside) {
                above = split(chains_[vertex.below]);
            }
        } else {
            for (std::size_t i = 0; i + 1 < left.size(); ++i) {
                if (inside_above(left[i]) && !close(chains_[left[i]], v)) {
                    return false;
                }
            }
            if (inside_above(left.back())) {
                above = chains_[left.back()];
            }
        }
        if (inside) {
            add_high(chains_[vertex.below], v);
        }
        if (above.low != kNone) {
            add_low(above, v);
        }
        for (const std::uint32_t e : right) {
            if (inside_above(e) == inside) {
                return false;
            }
            inside = !inside;
            if (inside) {
                chains_[e] = e == right.back() ? above : start(v);
            }
        }
        if (inside != (above.low != kNone)) {
            return false;
        }
        if (right.empty() && inside) {
            join(chains_[vertex.below], above);
        }
        return true;
    }

    std::uint32_t link(std::uint32_t point) {
        links_.push_back({point});
        return static_cast<std::uint32_t>(links_.size() - 1);
    }
    Chain start(std::uint32_t v) {
        const std::uint32_t at = link(v);
        return {at, at, at};
    }
    /// `chain` up to its newest point; returns the chain from there on.
    Chain split(Chain& chain) {
        const std::uint32_t copy = link(links_[chain.newest].point), up = links_[chain.newest].up;
        Chain rest{copy, up == kNone ? copy : chain.high, copy};
        links_[copy].up = up;
        if (up != kNone) {
            links_[up].down = copy;
        }
        links_[chain.newest].up = kNone;
        chain.high = chain.newest;
        return rest;
    }
    void add_high(Chain& chain, std::uint32_t v) {
        std::uint32_t at = chain.high;
        for (std::uint32_t down = links_[at].down; down != kNone && sees(down, v, at); down = links_[at].down) {
            triangle(down, v, at);
            at = down;
        }
        const std::uint32_t added = link(v);
        links_[added].down = at;
        links_[at].up = added;
        chain.high = chain.newest = added;
    }
    void add_low(Chain& chain, std::uint32_t v) {
        std::uint32_t at = chain.low;
        for (std::uint32_t up = links_[at].up; up != kNone && sees(at, v, up); up = links_[at].up) {
            triangle(at, v, up);
            at = up;
        }
        const std::uint32_t added = link(v);
        links_[added].up = at;
        links_[at].down = added;
        chain.low = chain.newest = added;
    }
    bool close(const Chain& chain, std::uint32_t v) {
        for (std::uint32_t at = chain.low, up = links_[at].up; up != kNone; at = up, up = links_[at].up) {
            if (side(at, v, up) < 0) {
                return false;
            }
            triangle(at, v, up);
        }
        return true;
    }
    /// Both end in the same point.
    void join(Chain& below, const Chain& above) {
        const std::uint32_t up = links_[above.low].up;
        links_[below.high].up = up;
        if (up != kNone) {
            links_[up].down = below.high;
            below.newest = below.high;
            below.high = above.high;
        }
    }

    [[nodiscard]] int side(std::uint32_t low, std::uint32_t v, std::uint32_t high) const {
        return turn_sign(points_[links_[low].point], points_[v], points_[links_[high].point]);
    }
    [[nodiscard]] bool sees(std::uint32_t low, std::uint32_t v, std::uint32_t high) const {
        return side(low, v, high) > 0;
    }
    void triangle(std::uint32_t low, std::uint32_t v, std::uint32_t high) {
        triangles.emplace_back(links_[low].point, v, links_[high].point);
    }

    std::span<const GridPoint> points_;
    const LoopEdges& edges_;
    std::vector<Chain> chains_;  ///< Of the region above each edge.
    std::vector<Link> links_;
};

}  // namespace

std::optional<std::vector<glm::uvec3>> triangulate_by_sweep(std::span<const GridPoint> points,
                                                            std::span<const std::vector<std::uint32_t>> loops) {
    std::vector<GridPoint> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end());
    const LoopEdges edges = edges_of(points, loops);
    if (edges.edges.empty() || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        return {};
    }
    Sweeper sweeper(points, edges);
    if (!sweeper.run()) {
        return {};
    }
    return std::move(sweeper.triangles);
}

}  // namespace csg::solid
