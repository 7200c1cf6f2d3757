// Holes are joined to the loop around them by a bridge (two edges in opposite directions), then ears are cut off. Which
// corners an ear could hold is looked up in a grid of the corners that are not convex.
#include "csg/solid/triangulate_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "csg/solid/triangulate.h"

namespace csg::solid {
namespace {

struct Corner {
    glm::dvec2 at;
    std::uint32_t index;
};
using Ring = std::vector<Corner>;

bool holds(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

bool is_inside(const Ring& ring, const glm::dvec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 &a = ring[i].at, &b = ring[(i + 1) % ring.size()].at;
        if ((a.y > p.y) != (b.y > p.y) && (turn(a, b, p) > 0) == (b.y > a.y))
            inside = !inside;
    }
    return inside;
}

/// Of the corners at the place of `corner` (bridges come back to where they began) the one with `from` in its angle.
std::size_t with_in_its_angle(const Ring& ring, std::size_t corner, const glm::dvec2& from) {
    const glm::dvec2 p = ring[corner].at;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (ring[i].at != p)
            continue;
        const glm::dvec2& before = ring[(i + ring.size() - 1) % ring.size()].at;
        const glm::dvec2& after = ring[(i + 1) % ring.size()].at;
        const bool left_of_first = turn(before, p, from) >= 0, left_of_second = turn(p, after, from) >= 0;
        if (turn(before, p, after) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second)
            return i;
    }
    return corner;
}

/// A corner of `outer` that is seen from the rightmost corner of a hole.
std::size_t bridge_to(const Ring& outer, const glm::dvec2& from) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    bool found = false;
    // The edge to the right whose outside is not towards the hole.
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const std::size_t j = (i + 1) % outer.size();
        const glm::dvec2 &a = outer[i].at, &b = outer[j].at;
        if (a.y > from.y || b.y < from.y || a.y == b.y)
            continue;
        const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x >= from.x && x < nearest) {
            nearest = x;
            best = a.x > b.x ? i : j;
            found = true;
        }
    }
    if (!found) {
        for (std::size_t i = 1; i < outer.size(); ++i) {
            if (glm::length(outer[i].at - from) < glm::length(outer[best].at - from))
                best = i;
        }
        return best;
    }
    const glm::dvec2 hit(nearest, from.y);
    if (outer[best].at == hit)
        return best;
    // Corners within the triangle of the three hide it; of these the one that is least off the ray is seen.
    const glm::dvec2 candidate = outer[best].at;
    double least = std::numeric_limits<double>::infinity();
    double nearness = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const glm::dvec2& p = outer[i].at;
        if (p == candidate || p.x < from.x)
            continue;
        const bool below = candidate.y < from.y;
        if (!(below ? holds(from, candidate, hit, p) : holds(from, hit, candidate, p)))
            continue;
        const glm::dvec2 &before = outer[(i + outer.size() - 1) % outer.size()].at,
                         &after = outer[(i + 1) % outer.size()].at;
        if (turn(before, p, after) > 0)
            continue;  // A convex corner hides nothing.
        const double slope = p.x > from.x ? std::abs(p.y - from.y) / (p.x - from.x) : 0;
        const double distance = glm::length(p - from);
        if (slope < least || (slope == least && distance < nearness)) {
            least = slope;
            nearness = distance;
            best = i;
        }
    }
    return best;
}

void join(Ring& outer, const Ring& hole) {
    std::size_t right = 0;
    for (std::size_t i = 1; i < hole.size(); ++i) {
        if (hole[i].at.x > hole[right].at.x)
            right = i;
    }
    const std::size_t to = with_in_its_angle(outer, bridge_to(outer, hole[right].at), hole[right].at);
    Ring inserted;
    inserted.reserve(hole.size() + 2);
    for (std::size_t i = 0; i <= hole.size(); ++i)
        inserted.push_back(hole[(right + i) % hole.size()]);
    inserted.push_back(outer[to]);
    outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(to) + 1, inserted.begin(), inserted.end());
}

/// The corners of a ring that are not convex, by cells.
class CornerGrid {
  public:
    CornerGrid(const Ring& ring, const std::vector<char>& convex) {
        lo_ = hi_ = ring[0].at;
        for (const Corner& c : ring) {
            lo_ = glm::min(lo_, c.at);
            hi_ = glm::max(hi_, c.at);
        }
        side_ = std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(ring.size()))), 1, 1024);
        cells_.resize(side_ * side_);
        for (std::uint32_t i = 0; i < ring.size(); ++i) {
            if (convex[i] == 0)
                cells_[column(ring[i].at.y, 1) * side_ + column(ring[i].at.x, 0)].push_back(i);
        }
    }
    template <typename Test>
    [[nodiscard]] bool any(const glm::dvec2& lo, const glm::dvec2& hi, Test&& test) const {
        for (std::size_t y = column(lo.y, 1); y <= column(hi.y, 1); ++y) {
            for (std::size_t x = column(lo.x, 0); x <= column(hi.x, 0); ++x) {
                const auto& cell = cells_[y * side_ + x];
                if (std::any_of(cell.begin(), cell.end(), test))
                    return true;
            }
        }
        return false;
    }

  private:
    [[nodiscard]] std::size_t column(double x, int axis) const {
        const double size = hi_[axis] - lo_[axis];
        const double at = size > 0 ? (x - lo_[axis]) / size * static_cast<double>(side_) : 0;
        return std::min(static_cast<std::size_t>(std::max(at, 0.0)), side_ - 1);
    }
    glm::dvec2 lo_, hi_;
    std::size_t side_ = 1;
    std::vector<std::vector<std::uint32_t>> cells_;
};

class EarCutter {
  public:
    EarCutter(const Ring& ring, std::vector<glm::uvec3>& triangles)
        : ring_(ring), triangles_(triangles), next_(ring.size()), before_(ring.size()), gone_(ring.size(), 0) {
        const auto n = static_cast<std::uint32_t>(ring.size());
        std::vector<char> convex(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            before_[i] = (i + n - 1) % n;
            convex[i] = turn(at(before_[i]), at(i), at(next_[i])) > 0;
        }
        grid_.emplace(ring, convex);
    }

    void run() {
        std::uint32_t here = 0;
        std::size_t left = ring_.size(), tried = 0;
        while (left > 3) {
            if (tried < left && !is_ear(here)) {
                here = next_[here];
                ++tried;
                continue;
            }
            // After a round without an ear (a ring that touches itself) any corner does: the mesh stays closed.
            cut(here);
            here = next_[next_[here]];
            --left;
            tried = 0;
        }
        triangle(before_[here], here, next_[here]);
    }

  private:
    [[nodiscard]] const glm::dvec2& at(std::uint32_t i) const { return ring_[i].at; }
    [[nodiscard]] bool is_ear(std::uint32_t i) const {
        const glm::dvec2 &a = at(before_[i]), &b = at(i), &c = at(next_[i]);
        if (!(turn(a, b, c) > 0))
            return false;
        const glm::dvec2 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
        return !grid_->any(lo, hi, [&](std::uint32_t other) {
            const glm::dvec2& p = at(other);
            return gone_[other] == 0 && p != a && p != b && p != c && holds(a, b, c, p);
        });
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles_.emplace_back(ring_[a].index, ring_[b].index, ring_[c].index);
    }
    void cut(std::uint32_t i) {
        triangle(before_[i], i, next_[i]);
        next_[before_[i]] = next_[i];
        before_[next_[i]] = before_[i];
        gone_[i] = 1;
    }

    const Ring& ring_;
    std::vector<glm::uvec3>& triangles_;
    std::vector<std::uint32_t> next_, before_;
    std::vector<char> gone_;
    std::optional<CornerGrid> grid_;
};

bool is_convex(const Ring& ring) {
    int changes = 0;
    double last = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 &a = ring[i].at, &b = ring[(i + 1) % ring.size()].at, &c = ring[(i + 2) % ring.size()].at;
        if (turn(a, b, c) <= 0)
            return false;
        const double direction = b.x != a.x ? b.x - a.x : b.y - a.y;
        changes += direction * last < 0;
        last = direction;
    }
    return changes <= 2;
}

void fill_ring(const Ring& ring, std::vector<glm::uvec3>& triangles) {
    if (ring.size() < 3)
        return;
    if (is_convex(ring)) {
        std::vector<std::uint32_t> face;
        for (const Corner& c : ring)
            face.push_back(c.index);
        triangulate_convex(face, triangles);
        return;
    }
    EarCutter(ring, triangles).run();
}

}  // namespace

std::vector<glm::uvec3> triangulate_region(const Outline& outline) {
    std::vector<Ring> outer, holes;
    std::vector<double> areas;  // Of the outer ones.
    std::uint32_t index = 0;
    for (const Loop& loop : outline.loops) {
        Ring ring;
        for (const glm::dvec2& p : loop)
            ring.push_back({p, index++});
        const double area = area2(loop);
        if (area < 0) {
            holes.push_back(std::move(ring));
        } else {
            outer.push_back(std::move(ring));
            areas.push_back(area);
        }
    }
    // Each hole belongs to the smallest loop around it.
    std::vector<std::vector<std::size_t>> holes_of(outer.size());
    std::vector<glm::uvec3> triangles;
    for (std::size_t h = 0; h < holes.size(); ++h) {
        std::size_t best = outer.size();
        for (std::size_t o = 0; o < outer.size(); ++o) {
            const glm::dvec2 middle = 0.5 * (holes[h][0].at + holes[h][1].at);
            if (is_inside(outer[o], middle) && (best == outer.size() || areas[o] < areas[best]))
                best = o;
        }
        if (best < outer.size())
            holes_of[best].push_back(h);
        else
            fill_ring(holes[h], triangles);  // A hole in nothing: closed all the same.
    }
    for (std::size_t o = 0; o < outer.size(); ++o) {
        // From right to left, so that a bridge never meets a hole that comes later.
        const auto right = [&](std::size_t h) {
            double x = holes[h][0].at.x;
            for (const Corner& c : holes[h])
                x = std::max(x, c.at.x);
            return x;
        };
        std::sort(holes_of[o].begin(), holes_of[o].end(),
                  [&](std::size_t a, std::size_t b) { return right(a) > right(b); });
        for (const std::size_t h : holes_of[o])
            join(outer[o], holes[h]);
        fill_ring(outer[o], triangles);
    }
    return triangles;
}

}  // namespace csg::solid
