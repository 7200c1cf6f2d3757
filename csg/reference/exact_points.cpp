#include "csg/reference/exact_points.h"

namespace csg::reference {
namespace {

constexpr double kHairPerSize = 0x1p-40;

/// The middle of the number's interval, once that is narrow.
double middle(const ExactKernel::FT& x, double hair) {
    if (!(x.approx().sup() - x.approx().inf() <= hair)) {
        (void)x.exact();
    }
    return 0.5 * (x.approx().sup() + x.approx().inf());
}

}  // namespace

ExactPoints::ExactPoints(double size) : hair_(size > 0 ? size * kHairPerSize : 1.0), grid_(2 * hair_) {}

std::uint32_t ExactPoints::add(const Point& point) {
    const glm::dvec3 near(middle(point.x(), hair_), middle(point.y(), hair_), middle(point.z(), hair_));
    const std::uint32_t known = grid_.find(near, [&](std::uint32_t id) { return points_[id] == point; });
    if (known != PointGrid::kNone) {
        return known;
    }
    points_.push_back(point);
    return grid_.add(near);
}

glm::dvec3 ExactPoints::rounded(std::uint32_t id) const {
    const Point& p = points_[id];
    const auto coordinate = [](const ExactKernel::FT& x) {
        const auto& interval = x.approx();
        return interval.is_point() ? interval.inf() : CGAL::to_double(x.exact());
    };
    return {coordinate(p.x()), coordinate(p.y()), coordinate(p.z())};
}

}  // namespace csg::reference
