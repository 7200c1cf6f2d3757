#include "csg/solid/bent_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "csg/solid/indexed_outline.h"
#include "csg/solid/sweep_triangulation.h"

namespace csg::solid {
namespace {

using Face = std::span<const std::uint32_t>;
using Loop = std::vector<glm::dvec2>;

/// Of the largest triangle over the two corners that are farthest apart along an axis; of equals, the last counts.
glm::dvec3 view_normal(std::span<const glm::dvec3> points, Face face) {
    std::array<glm::dvec3, 3> low, high;
    low.fill(points[face.back()]);
    high = low;
    for (auto corner = face.rbegin(); corner != face.rend(); ++corner) {
        const glm::dvec3& p = points[*corner];
        for (int i = 0; i < 3; ++i) {
            low[static_cast<std::size_t>(i)] =
                p[i] < low[static_cast<std::size_t>(i)][i] ? p : low[static_cast<std::size_t>(i)];
            high[static_cast<std::size_t>(i)] =
                p[i] > high[static_cast<std::size_t>(i)][i] ? p : high[static_cast<std::size_t>(i)];
        }
    }
    const auto extent = [&](int i) {
        return high[static_cast<std::size_t>(i)][i] - low[static_cast<std::size_t>(i)][i];
    };
    std::size_t longest = extent(1) > extent(0) ? 1 : 0;
    longest = extent(2) > extent(static_cast<int>(longest)) ? 2 : longest;
    glm::dvec3 normal(0.0);
    for (auto corner = face.rbegin(); corner != face.rend(); ++corner) {
        const glm::dvec3 across = glm::cross(low[longest] - high[longest], points[*corner] - high[longest]);
        normal = glm::dot(across, across) > glm::dot(normal, normal) ? across : normal;
    }
    return normal;
}

/// The face seen along the axis that its normal is nearest to, counter-clockwise.
Loop seen_along_axis(std::span<const glm::dvec3> points, Face face, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    int axis = size.y > size.x ? 1 : 0;
    axis = size.z > size[axis] ? 2 : axis;
    Loop loop;
    for (const std::uint32_t index : face) {
        loop.emplace_back(points[index][(axis + 1) % 3], points[index][(axis + 2) % 3]);
    }
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        area += (a.x - b.x) * (a.y + b.y);
    }
    for (glm::dvec2& p : loop) {
        p.y = area < 0 ? -p.y : p.y;
    }
    return loop;
}

bool before(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

double area_of(const Loop& loop, const glm::uvec3& t) {
    const glm::dvec2 a = loop[t.y] - loop[t.x], b = loop[t.z] - loop[t.x];
    return a.x * b.y - a.y * b.x;
}

/// Sweeps a loop that any vertical line meets twice at most from right to left; nothing for other loops.
std::optional<std::vector<glm::uvec3>> sweep(const Loop& loop) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    const auto [left, right] = std::minmax_element(loop.begin(), loop.end(), before);
    // Places count from the right end on, against the clock: first the upper chain, then the lower one.
    const auto first = static_cast<std::uint32_t>(right - loop.begin());
    const std::uint32_t end = (static_cast<std::uint32_t>(left - loop.begin()) + n - first) % n;
    const auto at = [&](std::uint32_t place) -> const glm::dvec2& { return loop[(first + place) % n]; };
    for (std::uint32_t place = 0; place < n; ++place) {
        if (place < end ? !before(at(place + 1), at(place)) : !before(at(place), at(place + 1))) {
            return std::nullopt;
        }
    }
    std::vector<glm::uvec3> triangles;
    const auto triangle = [&](std::array<std::uint32_t, 3> places) {
        std::sort(places.begin(), places.end());
        return glm::uvec3((first + places[0]) % n, (first + places[1]) % n, (first + places[2]) % n);
    };
    std::vector<std::uint32_t> order(n), waiting;
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return before(at(b), at(a)); });
    for (const std::uint32_t place : order) {
        if (waiting.size() >= 2 && (place == end || (place < end) != (waiting.back() < end))) {
            for (std::size_t i = 1; i < waiting.size(); ++i) {
                triangles.push_back(triangle({waiting[i - 1], waiting[i], place}));
            }
            waiting.erase(waiting.begin(), waiting.end() - 1);
        } else {
            while (waiting.size() >= 2) {
                const glm::uvec3 cut = triangle({waiting[waiting.size() - 2], waiting.back(), place});
                if (area_of(loop, cut) < 0) {
                    break;
                }
                triangles.push_back(cut);
                waiting.pop_back();
            }
        }
        waiting.push_back(place);
    }
    return triangles;
}

/// Triangles whose edges are turned as Delaunay's rule has them.
class Flipping {
  public:
    Flipping(const Loop& loop, std::vector<glm::uvec3>& triangles) : loop_(loop), triangles_(triangles) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            note(t);
        }
        for (const glm::uvec3& t : triangles) {
            for (int i = 0; i < 3; ++i) {
                push(t[i], t[(i + 1) % 3]);
            }
        }
    }

    void run() {
        // It ends by itself but for rounding.
        const std::size_t most = triangles_.size() * triangles_.size();
        for (std::size_t step = 0; !pending_.empty() && step < most; ++step) {
            const auto [a, b] = pending_.back();
            pending_.pop_back();
            if (edges_.contains({a, b}) && edges_.contains({b, a})) {
                settle(a, b);
            }
        }
    }

  private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    void note(std::size_t t) {
        for (int i = 0; i < 3; ++i) {
            edges_[{triangles_[t][i], triangles_[t][(i + 1) % 3]}] = t;
        }
    }
    void push(std::uint32_t a, std::uint32_t b) {
        if (edges_.contains({b, a})) {
            pending_.emplace_back(a, b);
        }
    }
    [[nodiscard]] std::uint32_t opposite(std::size_t t, std::uint32_t a, std::uint32_t b) const {
        const glm::uvec3& corners = triangles_[t];
        return corners.x + corners.y + corners.z - a - b;
    }
    [[nodiscard]] double angle(std::uint32_t a, std::uint32_t at, std::uint32_t b) const {
        const glm::dvec2 u = loop_[a] - loop_[at], v = loop_[b] - loop_[at];
        const double lengths = std::sqrt(glm::dot(u, u)) * std::sqrt(glm::dot(v, v));
        return lengths > 0 ? std::acos(std::clamp(glm::dot(u, v) / lengths, -1.0, 1.0)) : std::numbers::pi / 2;
    }
    void settle(std::uint32_t a, std::uint32_t b) {
        constexpr double kSlack = 0.01;  // Corners nearly on a circle stay as they were swept.
        const std::size_t here = edges_[{a, b}], there = edges_[{b, a}];
        const std::uint32_t c = opposite(here, a, b), d = opposite(there, b, a);
        if (angle(a, c, b) + angle(a, d, b) < std::numbers::pi + kSlack) {
            return;
        }
        edges_.erase({a, b});
        edges_.erase({b, a});
        triangles_[here] = {c, a, d};
        triangles_[there] = {d, b, c};
        note(here);
        note(there);
        for (const auto& [from, to] : {Edge{a, d}, Edge{d, b}, Edge{b, c}, Edge{c, a}}) {
            push(from, to);
        }
    }

    const Loop& loop_;
    std::vector<glm::uvec3>& triangles_;
    std::map<Edge, std::size_t> edges_;
    std::vector<Edge> pending_;
};

/// Whether corners lie off the plane of the face so far that it shows how the face is split.
bool is_bent(std::span<const glm::dvec3> points, Face face, const glm::dvec3& normal) {
    constexpr double kFlat = 1e-9;  // Of the face's size.
    const double length = glm::length(normal);
    if (!(length > 0) || !std::isfinite(length)) {
        return false;
    }
    double size = 0, height = 0;
    for (const std::uint32_t index : face) {
        const glm::dvec3 p = points[index] - points[face[0]];
        size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        height = std::max(height, std::abs(glm::dot(normal, p)) / length);
    }
    return height > kFlat * size;
}

}  // namespace

bool triangulate_bent(std::span<const glm::dvec3> points, std::span<const std::uint32_t> face,
                      std::vector<glm::uvec3>& triangles) {
    const glm::dvec3 normal = view_normal(points, face);
    if (!is_bent(points, face, normal)) {
        return false;
    }
    const Loop loop = seen_along_axis(points, face, normal);
    std::optional<std::vector<glm::uvec3>> flat = sweep(loop);
    if (!flat) {
        std::vector<std::uint32_t> around(loop.size());
        std::iota(around.begin(), around.end(), 0u);
        flat = triangulate_by_sweep(exact_points(loop), std::span(&around, 1));
    }
    if (!flat || std::any_of(flat->begin(), flat->end(), [&](const glm::uvec3& t) { return area_of(loop, t) < 0; })) {
        return false;
    }
    Flipping(loop, *flat).run();
    for (const glm::uvec3& t : *flat) {
        triangles.emplace_back(face[t.x], face[t.y], face[t.z]);
    }
    return true;
}

}  // namespace csg::solid
