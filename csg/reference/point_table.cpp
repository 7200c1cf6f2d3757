#include "csg/reference/point_table.h"

#include <cmath>

#include "csg/tree/hash.h"

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr double kCellsPerTolerance = 64;  // wide cells: a search rarely looks into more than one

std::int64_t cell_of(double x, double size) {
    return static_cast<std::int64_t>(std::floor(x / size));
}

}  // namespace

PointTable::PointTable(double tolerance)
    : tolerance_(tolerance), cell_(tolerance > 0 ? tolerance * kCellsPerTolerance : 1.0), buckets_(256, kNone) {}

std::size_t PointTable::bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
    std::uint64_t h = mix(0, static_cast<std::uint64_t>(x));
    h = mix(h, static_cast<std::uint64_t>(y));
    return mix(h, static_cast<std::uint64_t>(z)) & (buckets_.size() - 1);
}

void PointTable::insert(std::uint32_t id) {
    const glm::dvec3& p = points_[id];
    std::uint32_t& head = buckets_[bucket(cell_of(p.x, cell_), cell_of(p.y, cell_), cell_of(p.z, cell_))];
    next_[id] = head;
    head = id;
}

std::uint32_t PointTable::add(const glm::dvec3& point) {
    const glm::dvec3 lo = point - tolerance_, hi = point + tolerance_;
    for (std::int64_t x = cell_of(lo.x, cell_); x <= cell_of(hi.x, cell_); ++x)
        for (std::int64_t y = cell_of(lo.y, cell_); y <= cell_of(hi.y, cell_); ++y)
            for (std::int64_t z = cell_of(lo.z, cell_); z <= cell_of(hi.z, cell_); ++z)
                for (std::uint32_t id = buckets_[bucket(x, y, z)]; id != kNone; id = next_[id]) {
                    const glm::dvec3 d = points_[id] - point;
                    if (glm::dot(d, d) <= tolerance_ * tolerance_)
                        return id;
                }
    const auto id = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
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

}  // namespace csg::reference
