#include "csg/reference/exact_points.h"

#include <cmath>

#include "csg/tree/hash.h"

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr double kHairPerSize = 0x1p-40;
constexpr double kCellsPerHair = 64;  // wide cells: a search rarely looks into more than one

std::int64_t cell_of(double x, double size) {
    return static_cast<std::int64_t>(std::floor(x / size));
}

/// The middle of the number's interval, once that is narrow.
double middle(const ExactKernel::FT& x, double hair) {
    if (!(x.approx().sup() - x.approx().inf() <= hair))
        (void)x.exact();
    return 0.5 * (x.approx().sup() + x.approx().inf());
}

}  // namespace

ExactPoints::ExactPoints(double size)
    : hair_(size > 0 ? size * kHairPerSize : 1.0), cell_(hair_ * kCellsPerHair), buckets_(256, kNone) {}

std::size_t ExactPoints::bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
    std::uint64_t h = mix(0, static_cast<std::uint64_t>(x));
    h = mix(h, static_cast<std::uint64_t>(y));
    return mix(h, static_cast<std::uint64_t>(z)) & (buckets_.size() - 1);
}

void ExactPoints::insert(std::uint32_t id) {
    const glm::dvec3& p = near_[id];
    std::uint32_t& head = buckets_[bucket(cell_of(p.x, cell_), cell_of(p.y, cell_), cell_of(p.z, cell_))];
    next_[id] = head;
    head = id;
}

std::uint32_t ExactPoints::add(const Point& point) {
    const glm::dvec3 near(middle(point.x(), hair_), middle(point.y(), hair_), middle(point.z(), hair_));
    const glm::dvec3 lo = near - 2 * hair_, hi = near + 2 * hair_;
    for (std::int64_t x = cell_of(lo.x, cell_); x <= cell_of(hi.x, cell_); ++x)
        for (std::int64_t y = cell_of(lo.y, cell_); y <= cell_of(hi.y, cell_); ++y)
            for (std::int64_t z = cell_of(lo.z, cell_); z <= cell_of(hi.z, cell_); ++z)
                for (std::uint32_t id = buckets_[bucket(x, y, z)]; id != kNone; id = next_[id]) {
                    const glm::dvec3 way = glm::abs(near_[id] - near);
                    if (way.x <= 2 * hair_ && way.y <= 2 * hair_ && way.z <= 2 * hair_ && points_[id] == point)
                        return id;
                }
    const auto id = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    near_.push_back(near);
    next_.push_back(kNone);
    if (points_.size() * 2 > buckets_.size()) {
        buckets_.assign(buckets_.size() * 2, kNone);
        for (std::uint32_t i = 0; i <= id; ++i)
            insert(i);
    } else {
        insert(id);
    }
    return id;
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
