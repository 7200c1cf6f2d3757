#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

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

/// Where more than two planes share a line, a segment on it may be split in a plane that its neighbor on the line does
/// not lie in: what is split in one is split in all.
class SplitSharer {
  public:
    SplitSharer(Content& content, std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps)
        : content_(content), overlaps_(std::move(overlaps)), splits_(content.segments.size()) {
        std::sort(overlaps_.begin(), overlaps_.end());
        overlaps_.erase(std::unique(overlaps_.begin(), overlaps_.end()), overlaps_.end());
        for (const auto& [a, b] : overlaps_) {
            for (const std::uint32_t id : {a, b}) {
                if (splits_[id].empty()) {
                    splits_[id] = content.segments[id].splits;
                    std::sort(splits_[id].begin(), splits_[id].end());
                    splits_[id].erase(std::unique(splits_[id].begin(), splits_[id].end()), splits_[id].end());
                }
            }
        }
    }

    void share(const std::stop_token& stop) {
        base::PacedStop paced(stop);
        for (bool again = true; again;) {
            again = false;
            for (const auto& [a, b] : overlaps_) {
                paced();
                again |= pass_on(a, b);
                again |= pass_on(b, a);
            }
        }
    }

  private:
    /// Points of `from` that lie on `to` split it; true where there are new ones.
    bool pass_on(std::uint32_t from, std::uint32_t to) {
        found_.clear();
        std::set_difference(splits_[from].begin(), splits_[from].end(), splits_[to].begin(), splits_[to].end(),
                            std::back_inserter(found_));
        if (found_.empty()) {
            return false;
        }
        const SegmentTable::Segment& t = content_.segments[to];
        const glm::dvec3 start = content_.points[t.from], along = content_.points[t.to] - start;
        const double length = glm::length(along), tolerance = content_.points.tolerance();
        std::erase_if(found_, [&](std::uint32_t p) {
            const double at = glm::dot(content_.points[p] - start, along) / length;
            return p == t.from || p == t.to || at <= 0 || at >= length ||
                   glm::length(glm::cross(content_.points[p] - start, along)) > 2 * tolerance * length;
        });
        for (const std::uint32_t p : found_) {
            content_.segments.split(to, p);
        }
        std::vector<std::uint32_t>& all = splits_[to];
        const auto middle = all.insert(all.end(), found_.begin(), found_.end());
        std::inplace_merge(all.begin(), middle, all.end());
        return !found_.empty();
    }

    Content& content_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps_;
    std::vector<std::vector<std::uint32_t>> splits_;  ///< By segment, of those that overlap: sorted, each once.
    std::vector<std::uint32_t> found_;
};

}  // namespace

void split_segments(Content& content, const std::stop_token& stop) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps;
    for (const PlaneContent& plane : content.planes) {
        base::end_if_asked(stop);
        if (plane.segments.size() > 1) {
            Splitter(content, plane, overlaps, stop).split();
        }
    }
    SplitSharer(content, std::move(overlaps)).share(stop);
}

}  // namespace csg::reference
