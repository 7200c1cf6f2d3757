// Points found by where they are, within a reach.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "csg/tree/hash.h"

namespace csg::reference {

/// Points, numbered from 0 as they come, in the cells of a grid that is hashed.
class PointGrid {
  public:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// `reach`: how far `find` looks along each axis.
    explicit PointGrid(double reach)
        : reach_(reach), cell_(reach > 0 ? reach * kCellsPerReach : 1.0), buckets_(256, kNone) {}

    /// The last added point no farther from `point` than the reach for which `same(number)` holds; kNone without one.
    template <typename Same>
    [[nodiscard]] std::uint32_t find(const glm::dvec3& point, Same&& same) const {
        const glm::dvec3 lo = point - reach_, hi = point + reach_;
        for (std::int64_t x = cell_of(lo.x); x <= cell_of(hi.x); ++x) {
            for (std::int64_t y = cell_of(lo.y); y <= cell_of(hi.y); ++y) {
                for (std::int64_t z = cell_of(lo.z); z <= cell_of(hi.z); ++z) {
                    for (std::uint32_t id = buckets_[bucket(x, y, z)]; id != kNone; id = next_[id]) {
                        const glm::dvec3 way = glm::abs(points_[id] - point);
                        if (way.x <= reach_ && way.y <= reach_ && way.z <= reach_ && same(id)) {
                            return id;
                        }
                    }
                }
            }
        }
        return kNone;
    }

    std::uint32_t add(const glm::dvec3& point) {
        const auto id = static_cast<std::uint32_t>(points_.size());
        points_.push_back(point);
        next_.push_back(kNone);
        if (points_.size() * 2 > buckets_.size()) {
            buckets_.assign(buckets_.size() * 2, kNone);
            for (std::uint32_t i = 0; i <= id; ++i) {
                insert(i);
            }
        } else {
            insert(id);
        }
        return id;
    }

    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return points_; }

  private:
    static constexpr double kCellsPerReach = 64;  // wide cells: a search rarely looks into more than one

    [[nodiscard]] std::int64_t cell_of(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
    [[nodiscard]] std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
        std::uint64_t h = mix(0, static_cast<std::uint64_t>(x));
        h = mix(h, static_cast<std::uint64_t>(y));
        return mix(h, static_cast<std::uint64_t>(z)) & (buckets_.size() - 1);
    }
    void insert(std::uint32_t id) {
        const glm::dvec3& p = points_[id];
        std::uint32_t& head = buckets_[bucket(cell_of(p.x), cell_of(p.y), cell_of(p.z))];
        next_[id] = head;
        head = id;
    }

    double reach_, cell_;
    std::vector<glm::dvec3> points_;
    std::vector<std::uint32_t> next_;     ///< Chains of points in one bucket.
    std::vector<std::uint32_t> buckets_;  ///< Heads of the chains; a power of two of them.
};

}  // namespace csg::reference
