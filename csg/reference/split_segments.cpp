#include <algorithm>
#include <array>

#include "csg/reference/plane_axes.h"
#include "csg/reference/segments.h"

namespace csg::reference {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// One plane's segments; a sweep finds those that come near each other.
class Splitter {
  public:
    Splitter(Content& content, const PlaneContent& plane, const glm::dvec3& normal)
        : content_(content), axes_(normal), tolerance_(content.points.tolerance()) {
        items_.reserve(plane.segments.size());
        for (const std::uint32_t id : plane.segments) {
            const SegmentTable::Segment& s = content.segments[id];
            const glm::dvec2 a = axes_(content.points[s.from]), b = axes_(content.points[s.to]);
            items_.push_back({id, s.from, s.to, a, b, glm::min(a, b) - tolerance_, glm::max(a, b) + tolerance_});
        }
    }

    void split() {
        glm::dvec2 lo(1e300), hi(-1e300);
        for (const Item& item : items_) {
            lo = glm::min(lo, item.lo);
            hi = glm::max(hi, item.hi);
        }
        const int axis = hi.x - lo.x >= hi.y - lo.y ? 0 : 1;
        std::sort(items_.begin(), items_.end(), [axis](const Item& a, const Item& b) {
            return a.lo[axis] != b.lo[axis] ? a.lo[axis] < b.lo[axis] : a.id < b.id;
        });
        std::vector<const Item*> active;
        for (const Item& item : items_) {
            std::erase_if(active, [&](const Item* other) { return other->hi[axis] < item.lo[axis]; });
            for (const Item* other : active) {
                if (other->lo[1 - axis] <= item.hi[1 - axis] && item.lo[1 - axis] <= other->hi[1 - axis])
                    meet(*other, item);
            }
            active.push_back(&item);
        }
    }

  private:
    struct Item {
        std::uint32_t id, from, to;
        glm::dvec2 a, b, lo, hi;
    };

    /// Splits `item` at the point if it is on it.
    bool touch(const Item& item, std::uint32_t point, const glm::dvec2& at) {
        if (point == item.from || point == item.to)
            return true;
        const glm::dvec2 d = item.b - item.a;
        const double t = glm::dot(at - item.a, d), length2 = glm::dot(d, d);
        if (t <= 0 || t >= length2)
            return false;
        const double off = cross(d, at - item.a);
        if (off * off > tolerance_ * tolerance_ * length2)
            return false;
        content_.segments.split(item.id, point);
        return true;
    }

    void meet(const Item& s, const Item& t) {
        const bool touched = static_cast<int>(touch(s, t.from, t.a)) | static_cast<int>(touch(s, t.to, t.b)) |
                             static_cast<int>(touch(t, s.from, s.a)) | static_cast<int>(touch(t, s.to, s.b));
        if (touched)
            return;
        const glm::dvec2 d = s.b - s.a, e = t.b - t.a;
        const double a = cross(d, t.a - s.a), b = cross(d, t.b - s.a);
        const double c = cross(e, s.a - t.a), f = cross(e, s.b - t.a);
        if ((a > 0) == (b > 0) || (c > 0) == (f > 0))
            return;
        // The shorter of the two is the more accurate place to be.
        const auto between = [&](std::uint32_t from, std::uint32_t to, double at_from, double at_to) {
            const glm::dvec3 p = content_.points[from], q = content_.points[to];
            return p + (q - p) * (at_from / (at_from - at_to));
        };
        const bool along_s = glm::dot(d, d) < glm::dot(e, e);
        const glm::dvec3 at = along_s ? between(s.from, s.to, c, f) : between(t.from, t.to, a, b);
        const std::uint32_t point = content_.points.add(at);
        content_.segments.split(s.id, point);
        content_.segments.split(t.id, point);
    }

    Content& content_;
    PlaneAxes axes_;
    double tolerance_;
    std::vector<Item> items_;
};

}  // namespace

void split_segments(const solid::Geometry& geometry, Content& content) {
    for (std::size_t i = 0; i < content.planes.size(); ++i) {
        if (content.planes[i].segments.size() > 1)
            Splitter(content, content.planes[i], geometry.planes.planes()[i].normal).split();
    }
}

}  // namespace csg::reference
