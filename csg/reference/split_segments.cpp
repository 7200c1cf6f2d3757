#include <algorithm>
#include <array>

#include "base/stop.h"
#include "csg/reference/plane_axes.h"
#include "csg/reference/segments.h"
#include "csg/reference/sweep_pairs.h"

namespace csg::reference {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// One plane's segments; a sweep finds those that come near each other.
class Splitter {
  public:
    /// `overlaps`: takes the pairs of segments that have a piece in common.
    Splitter(Content& content, const PlaneContent& plane,
             std::vector<std::pair<std::uint32_t, std::uint32_t>>& overlaps, const std::stop_token& stop)
        : content_(content),
          axes_(plane.plane.normal),
          tolerance_(content.points.tolerance()),
          overlaps_(overlaps),
          paced_(stop) {
        items_.reserve(plane.segments.size());
        for (const std::uint32_t id : plane.segments) {
            const SegmentTable::Segment& s = content.segments[id];
            const glm::dvec2 a = axes_(content.points[s.from]), b = axes_(content.points[s.to]);
            items_.push_back({id, s.from, s.to, a, b, glm::min(a, b) - tolerance_, glm::max(a, b) + tolerance_});
        }
    }

    void split() {
        sweep_pairs(
            items_, [](const Item& item) { return item.id; }, [this] { paced_(); },
            [this](const Item& other, const Item& item) { meet(other, item); });
    }

  private:
    struct Item {
        std::uint32_t id, from, to;
        glm::dvec2 a, b, lo, hi;
    };

    /// Splits `item` at the point if it is on it.
    bool touch(const Item& item, std::uint32_t point, const glm::dvec2& at) {
        if (point == item.from || point == item.to) {
            return true;
        }
        const glm::dvec2 d = item.b - item.a;
        const double t = glm::dot(at - item.a, d), length2 = glm::dot(d, d);
        if (t <= 0 || t >= length2) {
            return false;
        }
        const double off = cross(d, at - item.a);
        if (off * off > tolerance_ * tolerance_ * length2) {
            return false;
        }
        content_.segments.split(item.id, point);
        return true;
    }

    /// Do segments that touch lie on one line, and on more than a point of it?
    bool overlap(const Item& s, const Item& t) const {
        const bool longer = glm::distance(s.a, s.b) >= glm::distance(t.a, t.b);
        const Item &l = longer ? s : t, &k = longer ? t : s;
        const glm::dvec2 d = (l.b - l.a) / glm::distance(l.a, l.b);
        if (std::abs(cross(d, k.a - l.a)) > tolerance_ || std::abs(cross(d, k.b - l.a)) > tolerance_) {
            return false;
        }
        const double length = glm::dot(d, l.b - l.a), p = glm::dot(d, k.a - l.a), q = glm::dot(d, k.b - l.a);
        return std::min(length, std::max(p, q)) - std::max(0.0, std::min(p, q)) > tolerance_;
    }

    void meet(const Item& s, const Item& t) {
        const bool touched = static_cast<int>(touch(s, t.from, t.a)) | static_cast<int>(touch(s, t.to, t.b)) |
                             static_cast<int>(touch(t, s.from, s.a)) | static_cast<int>(touch(t, s.to, s.b));
        if (touched) {
            if (overlap(s, t)) {
                overlaps_.emplace_back(std::min(s.id, t.id), std::max(s.id, t.id));
            }
            return;
        }
        const glm::dvec2 d = s.b - s.a, e = t.b - t.a;
        const double a = cross(d, t.a - s.a), b = cross(d, t.b - s.a);
        const double c = cross(e, s.a - t.a), f = cross(e, s.b - t.a);
        if ((a > 0) == (b > 0) || (c > 0) == (f > 0)) {
            return;
        }
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
    std::vector<std::pair<std::uint32_t, std::uint32_t>>& overlaps_;
    base::PacedStop paced_;
    std::vector<Item> items_;
};

/// Points of `from` that lie on `to` split it; true where there are new ones.
bool pass_on(Content& content, std::uint32_t from, std::uint32_t to) {
    const SegmentTable::Segment &s = content.segments[from], &t = content.segments[to];
    const glm::dvec3 start = content.points[t.from], along = content.points[t.to] - start;
    const double length = glm::length(along), tolerance = content.points.tolerance();
    std::vector<std::uint32_t> found;
    for (const std::uint32_t p : s.splits) {
        const double at = glm::dot(content.points[p] - start, along) / length;
        if (p == t.from || p == t.to || at <= 0 || at >= length) {
            continue;
        }
        if (glm::length(glm::cross(content.points[p] - start, along)) <= 2 * tolerance * length &&
            std::find(t.splits.begin(), t.splits.end(), p) == t.splits.end() &&
            std::find(found.begin(), found.end(), p) == found.end()) {
            found.push_back(p);
        }
    }
    for (const std::uint32_t p : found) {
        content.segments.split(to, p);
    }
    return !found.empty();
}

/// Where more than two planes share a line, a segment on it may be split in a plane that its neighbor on the line does
/// not lie in: what is split in one is split in all.
void share_splits(Content& content, std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps,
                  const std::stop_token& stop) {
    base::PacedStop paced(stop);
    std::sort(overlaps.begin(), overlaps.end());
    overlaps.erase(std::unique(overlaps.begin(), overlaps.end()), overlaps.end());
    for (bool again = true; again;) {
        again = false;
        for (const auto& [a, b] : overlaps) {
            paced();
            again |= pass_on(content, a, b);
            again |= pass_on(content, b, a);
        }
    }
}

}  // namespace

void split_segments(Content& content, const std::stop_token& stop) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps;
    for (const PlaneContent& plane : content.planes) {
        base::end_if_asked(stop);
        if (plane.segments.size() > 1) {
            Splitter(content, plane, overlaps, stop).split();
        }
    }
    share_splits(content, std::move(overlaps), stop);
}

}  // namespace csg::reference
