// Which corners an ear could hold is looked up in a grid of the corners that are not convex.
#include "csg/solid/ear_cutting.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/solid/outline.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostLookups = std::size_t{1} << 28;  // After so many, corners are cut off unseen.
constexpr std::size_t kMostRounds = 64;  // Without any ear; a ring with so many crosses itself all over.

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
            if (convex[i] == 0) {
                cells_[column(ring[i].at.y, 1) * side_ + column(ring[i].at.x, 0)].push_back(i);
            }
        }
    }
    /// Does `test` hold for any corner near the box? `lookups` grows by what that took.
    template <typename Test>
    [[nodiscard]] bool any(const glm::dvec2& lo, const glm::dvec2& hi, std::size_t& lookups, Test&& test) const {
        for (std::size_t y = column(lo.y, 1); y <= column(hi.y, 1); ++y) {
            for (std::size_t x = column(lo.x, 0); x <= column(hi.x, 0); ++x) {
                const auto& cell = cells_[y * side_ + x];
                lookups += 1 + cell.size();
                if (std::any_of(cell.begin(), cell.end(), test)) {
                    return true;
                }
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

bool holds(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

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
        std::size_t left = ring_.size(), tried = 0, rounds = 0;
        while (left > 3) {
            const bool looks = rounds < kMostRounds && lookups_ < kMostLookups;
            if (looks && tried < left && !is_ear(here)) {
                here = next_[here];
                ++tried;
                continue;
            }
            // After a round without an ear any corner does: the mesh stays closed.
            rounds += tried == left ? 1 : 0;
            cut(here);
            here = next_[next_[here]];
            --left;
            tried = 0;
        }
        triangle(before_[here], here, next_[here]);
    }

  private:
    [[nodiscard]] const glm::dvec2& at(std::uint32_t i) const { return ring_[i].at; }
    [[nodiscard]] bool is_ear(std::uint32_t i) {
        const glm::dvec2 &a = at(before_[i]), &b = at(i), &c = at(next_[i]);
        if (!(turn(a, b, c) > 0)) {
            return false;
        }
        const glm::dvec2 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
        return !grid_->any(lo, hi, lookups_, [&](std::uint32_t other) {
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
    std::size_t lookups_ = 0;
};

}  // namespace

void cut_ears(const Ring& ring, std::vector<glm::uvec3>& triangles) {
    EarCutter(ring, triangles).run();
}

}  // namespace csg::solid
