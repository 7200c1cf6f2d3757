#include "csg/reference/exact_splitter.h"

#include <algorithm>
#include <array>

#include "base/stop.h"
#include "csg/reference/sweep_pairs.h"

namespace csg::reference {

ExactSplitter::ExactSplitter(ExactSegments& segments, std::uint32_t plane) : segments_(segments), plane_(plane) {
    const ExactPlane& axes = segments.faces_.planes[plane];
    const double hair = 0x1p-38 * segments.faces_.largest;
    for (const std::uint32_t id : segments.planes_[plane].segments) {
        const ExactSegment& s = segments.segments_[id];
        const glm::dvec3 &p = segments.points_.near(s.from), &q = segments.points_.near(s.to);
        const glm::dvec2 a(p[axes.u], p[axes.v]), b(q[axes.u], q[axes.v]);
        items_.push_back({id, s.from, s.to, glm::min(a, b) - hair, glm::max(a, b) + hair});
    }
}

void ExactSplitter::split(const std::stop_token& stop) {
    sweep_pairs(
        items_, [](const Item& item) { return item.segment; }, [&] { base::end_if_asked(stop); },
        [this](const Item& other, const Item& item) { meet(other, item); });
}

const ExactKernel::Point_2& ExactSplitter::picture(std::uint32_t point) {
    auto at = pictures_.find(point);
    if (at == pictures_.end()) {
        at = pictures_.emplace(point, segments_.picture(plane_, point)).first;
    }
    return at->second;
}

int ExactSplitter::turn(std::uint32_t from, std::uint32_t to, std::uint32_t point) {
    if (point == from || point == to) {
        return 0;
    }
    return CGAL::orientation(picture(from), picture(to), picture(point));
}

void ExactSplitter::meet(const Item& s, const Item& t) {
    const int from_t = turn(s.from, s.to, t.from), to_t = turn(s.from, s.to, t.to);
    if (from_t == 0 && to_t == 0) {
        if (overlap(s, t)) {
            segments_.overlaps_.emplace_back(s.segment, t.segment);
        }
        return;
    }
    if (from_t * to_t > 0) {
        return;
    }
    const int from_s = turn(t.from, t.to, s.from), to_s = turn(t.from, t.to, s.to);
    if (from_s * to_s > 0) {
        return;
    }
    const bool through_s = from_s * to_s < 0, through_t = from_t * to_t < 0;
    if (through_s && through_t) {
        const std::uint32_t point =
            segments_.crossing(segments_.segments_[s.segment], segments_.segments_[t.segment], plane_);
        segments_.splits_[s.segment].push_back(point);
        segments_.splits_[t.segment].push_back(point);
    } else if (through_s) {
        segments_.splits_[s.segment].push_back(from_t == 0 ? t.from : t.to);
    } else if (through_t) {
        segments_.splits_[t.segment].push_back(from_s == 0 ? s.from : s.to);
    }
}

/// Do segments on one line have more than a point in common?
bool ExactSplitter::overlap(const Item& s, const Item& t) {
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        return a != b && CGAL::compare_xy(picture(a), picture(b)) == CGAL::SMALLER;
    };
    const auto ends = [&](const Item& of) {
        return less(of.from, of.to) ? std::array{of.from, of.to} : std::array{of.to, of.from};
    };
    const auto [s_lo, s_hi] = ends(s);
    const auto [t_lo, t_hi] = ends(t);
    return less(t_lo, s_hi) && less(s_lo, t_hi);
}

}  // namespace csg::reference
