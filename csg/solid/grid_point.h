// Points in whole numbers, and exact answers about segments between them.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <cstdlib>

namespace csg::solid {

__extension__ typedef __int128 Wide;

/// Ordered by x, then y. Coordinates stay within ±2^60, so that no answer below can overflow.
struct GridPoint {
    std::int64_t x = 0, y = 0;
    auto operator<=>(const GridPoint&) const = default;
};

[[nodiscard]] inline Wide cross(const GridPoint& a, const GridPoint& b) {
    return static_cast<Wide>(a.x) * b.y - static_cast<Wide>(a.y) * b.x;
}
[[nodiscard]] inline Wide dot(const GridPoint& a, const GridPoint& b) {
    return static_cast<Wide>(a.x) * b.x + static_cast<Wide>(a.y) * b.y;
}
[[nodiscard]] inline GridPoint operator-(const GridPoint& a, const GridPoint& b) {
    return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline int sign(Wide value) {
    return (value > 0) - (value < 0);
}

/// 1 where c lies to the left of the way from a to b, -1 to the right, 0 on the line.
[[nodiscard]] inline int turn_sign(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return sign(cross(b - a, c - a));
}

/// From the lesser point to the greater one. What lies above it (to the left of the way from a to b) is wound around
/// by `weight` more than what lies below: twice, by two numbers that are counted apart.
struct GridEdge {
    GridPoint a, b;
    std::int32_t weight = 0, other = 0;
};

/// The edge of a loop that goes from p to q; p and q differ.
[[nodiscard]] inline GridEdge directed_edge(const GridPoint& p, const GridPoint& q, bool other = false) {
    const int way = p < q ? 1 : -1;
    return {std::min(p, q), std::max(p, q), other ? 0 : way, other ? way : 0};
}

/// Do they cross, overlap, or touch anywhere but where both end?
[[nodiscard]] inline bool conflict(const GridEdge& e, const GridEdge& f) {
    if (f.b < e.a || e.b < f.a || std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) ||
        std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y)) {
        return false;
    }
    const int ea = turn_sign(f.a, f.b, e.a), eb = turn_sign(f.a, f.b, e.b);
    const int fa = turn_sign(e.a, e.b, f.a), fb = turn_sign(e.a, e.b, f.b);
    if (ea == 0 && eb == 0) {
        return std::max(e.a, f.a) < std::min(e.b, f.b);
    }
    if (ea * eb > 0 || fa * fb > 0) {
        return false;
    }
    return !(e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b);
}

/// The order, bottom to top, of edges that do not conflict and that some vertical line meets both.
[[nodiscard]] inline bool is_below(const GridEdge& e, const GridEdge& f) {
    if (e.a < f.a) {
        const int side = turn_sign(e.a, e.b, f.a);
        return side != 0 ? side > 0 : turn_sign(e.a, e.b, f.b) > 0;
    }
    const int side = turn_sign(f.a, f.b, e.a);
    return side != 0 ? side < 0 : turn_sign(f.a, f.b, e.b) < 0;
}

}  // namespace csg::solid
