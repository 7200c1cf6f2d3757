#include "goldfeather/lists_cpu/screen_triangles.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace goldfeather {

namespace {

/// How far outside the picture coordinates may lie, in pixels.
constexpr double kGuard = 2048;

/// A convex polygon of a few corners: a triangle after up to five cuts.
template <typename Point>
struct Polygon {
    std::array<Point, 9> points;
    int count = 0;
    void add(const Point& p) { points[static_cast<std::size_t>(count++)] = p; }
};

bool before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}
bool before(const glm::dvec2& a, const glm::dvec2& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

/// Keeps the side where `height` is not negative. The cut of an edge is computed from its ends in one order, whoever
/// asks.
template <typename Point, typename Height>
Polygon<Point> cut(const Polygon<Point>& polygon, const Height& height) {
    Polygon<Point> kept;
    for (int i = 0; i < polygon.count; ++i) {
        const Point& p = polygon.points[static_cast<std::size_t>(i)];
        const Point& q = polygon.points[static_cast<std::size_t>((i + 1) % polygon.count)];
        const double hp = height(p), hq = height(q);
        if (hp >= 0) {
            kept.add(p);
        }
        if ((hp >= 0) != (hq >= 0)) {
            const bool forward = before(p, q);
            const Point &from = forward ? p : q, &to = forward ? q : p;
            const double hf = forward ? hp : hq, ht = forward ? hq : hp;
            kept.add(from + (to - from) * (hf / (hf - ht)));
        }
    }
    return kept;
}

class Projector {
  public:
    /// `from_behind`: the bit of triangles seen from behind.
    Projector(const base::View& view, csg::LeafId leaf, std::uint32_t from_behind, std::vector<ScreenTriangle>& out)
        : view_(view),
          leaf_(leaf),
          from_behind_(from_behind),
          out_(out),
          scale_(view.size().y / (2 * view.half_height())),
          offset_(0.5 * glm::dvec2(view.size()) - view.jitter()) {}

    [[nodiscard]] glm::dvec2 on_screen(const glm::dvec3& eye) const {
        const double w = view_.orthographic() ? 1.0 : -eye.z;
        return glm::dvec2(eye) * (scale_ / w) + offset_;
    }
    [[nodiscard]] bool hidden(const glm::dvec3& eye) const {
        return !view_.orthographic() && -eye.z < view_.near_distance();
    }
    [[nodiscard]] double depth(const glm::dvec3& eye) const { return view_.depth(-eye.z); }
    [[nodiscard]] bool in_guard(const glm::dvec2& p) const {
        return p.x >= -kGuard && p.y >= -kGuard && p.x <= view_.size().x + kGuard && p.y <= view_.size().y + kGuard;
    }

    /// A triangle that needs cutting.
    void add_cut(const std::array<glm::dvec3, 3>& eye, std::uint32_t plane) const {
        Polygon<glm::dvec3> solid;
        for (const glm::dvec3& p : eye) {
            solid.add(p);
        }
        if (!view_.orthographic()) {
            solid = cut(solid, [&](const glm::dvec3& p) { return -p.z - view_.near_distance(); });
        }
        if (solid.count < 3) {
            return;
        }
        ScreenTriangle t{{}, {}, leaf_ << 1, plane, 1, 0};
        Polygon<glm::dvec2> flat;
        for (const glm::dvec3& p : std::span(solid.points).first(static_cast<std::size_t>(solid.count))) {
            flat.add(on_screen(p));
            t.farthest = std::min(t.farthest, depth(p));
            t.nearest = std::max(t.nearest, depth(p));
        }
        const glm::dvec2 high = glm::dvec2(view_.size()) + kGuard;
        flat = cut(flat, [](const glm::dvec2& p) { return p.x + kGuard; });
        flat = cut(flat, [](const glm::dvec2& p) { return p.y + kGuard; });
        flat = cut(flat, [&](const glm::dvec2& p) { return high.x - p.x; });
        flat = cut(flat, [&](const glm::dvec2& p) { return high.y - p.y; });
        for (int i = 2; i < flat.count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            add(t, {flat.points[0], flat.points[at - 1], flat.points[at]});
        }
    }

    /// Snaps, turns, and leaves out what covers no sample.
    void add(ScreenTriangle t, const std::array<glm::dvec2, 3>& at) const {
        for (std::size_t i = 0; i < 3; ++i) {
            t.x[i] = static_cast<std::int32_t>(std::floor(at[i].x * kSubpixels + 0.5));
            t.y[i] = static_cast<std::int32_t>(std::floor(at[i].y * kSubpixels + 0.5));
        }
        const std::int64_t area = (std::int64_t{t.x[1]} - t.x[0]) * (std::int64_t{t.y[2]} - t.y[0]) -
                                  (std::int64_t{t.x[2]} - t.x[0]) * (std::int64_t{t.y[1]} - t.y[0]);
        if (area == 0) {
            return;
        }
        if (area < 0) {
            std::swap(t.x[1], t.x[2]);
            std::swap(t.y[1], t.y[2]);
            t.leaf_and_side |= from_behind_;
        }
        const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
        const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
        // Is there a pixel center within the box, and in the picture?
        constexpr std::int32_t kHalf = kSubpixels / 2;
        const auto first = [](std::int32_t v) { return (v + kHalf - 1) >> kSubpixelBits; };
        const auto last = [](std::int32_t v) { return (v - kHalf) >> kSubpixelBits; };
        if (std::max(first(x0), 0) <= std::min(last(x1), view_.size().x - 1) &&
            std::max(first(y0), 0) <= std::min(last(y1), view_.size().y - 1)) {
            out_.push_back(t);
        }
    }

  private:
    const base::View& view_;
    csg::LeafId leaf_;
    std::uint32_t from_behind_;
    std::vector<ScreenTriangle>& out_;
    double scale_;
    glm::dvec2 offset_;
};

}  // namespace

void project_leaf(const csg::solid::PlacedLeaf& leaf, csg::LeafId id, const base::View& view,
                  std::vector<ScreenTriangle>& out) {
    struct Vertex {
        glm::dvec3 eye;
        glm::dvec2 screen;
        double depth;
        bool plain;
    };
    const Projector projector(view, id, leaf.solid->winds() ? 1 : 0, out);
    thread_local std::vector<Vertex> vertices;
    vertices.clear();
    vertices.reserve(leaf.points.size());
    for (const glm::dvec3& p : leaf.points) {
        Vertex v{glm::dvec3(view.eye_from_world() * glm::dvec4(p, 1.0)), {}, 0, false};
        if (!projector.hidden(v.eye)) {
            v.screen = projector.on_screen(v.eye);
            v.depth = projector.depth(v.eye);
            v.plain = projector.in_guard(v.screen);
        }
        vertices.push_back(v);
    }
    for (std::size_t i = 0; i < leaf.triangles.size(); ++i) {
        const glm::uvec3& t = leaf.triangles[i];
        const Vertex &a = vertices[t.x], &b = vertices[t.y], &c = vertices[t.z];
        if (a.plain && b.plain && c.plain) {
            const auto [farthest, nearest] = std::minmax({a.depth, b.depth, c.depth});
            projector.add({{}, {}, id << 1, leaf.planes[i].index, farthest, nearest}, {a.screen, b.screen, c.screen});
        } else {
            projector.add_cut({a.eye, b.eye, c.eye}, leaf.planes[i].index);
        }
    }
}

bool near_plane_cuts(const base::View& view, const csg::Box& box) {
    if (view.orthographic() || box.empty()) {
        return false;
    }
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                                (i & 4) != 0 ? box.hi.z : box.lo.z, 1.0);
        if (-(view.eye_from_world() * corner).z <= view.near_distance()) {
            return true;
        }
    }
    return false;
}

}  // namespace goldfeather
