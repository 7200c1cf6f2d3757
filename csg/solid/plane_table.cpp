#include "csg/solid/plane_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/tree/hash.h"

namespace csg::solid {
namespace {

constexpr double kTolerancePerLength = 0x1p-33;
/// Cells of the hash: wide against the tolerance, narrow against the distance of unrelated planes.
constexpr double kNormalCell = 1e-3, kNormalMargin = 1e-6;
constexpr double kOffsetCell = 1e-4, kOffsetMargin = 2e-6;  // per unit of the largest coordinate
constexpr std::uint32_t kNone = ~std::uint32_t{0};

Plane plane_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    if (length > 0 && std::isfinite(length)) {
        const glm::dvec3 normal = n / length;
        return {normal, glm::dot(normal, a)};
    }
    glm::dvec3 edge = b - a;
    for (const glm::dvec3& e : {c - b, a - c}) {
        if (glm::dot(e, e) > glm::dot(edge, edge))
            edge = e;
    }
    const glm::dvec3 across =
        std::abs(edge.x) < std::abs(edge.z) ? glm::cross(edge, {1, 0, 0}) : glm::cross(edge, {0, 0, 1});
    const double size = glm::length(across);
    const glm::dvec3 normal = size > 0 && std::isfinite(size) ? across / size : glm::dvec3(0, 0, 1);
    return {normal, glm::dot(normal, a)};
}

double distance(const Plane& plane, const glm::dvec3& p) {
    return std::abs(glm::dot(plane.normal, p) - plane.offset);
}

/// The cells that a value within `margin` of x can lie in: one or two.
struct Cells {
    std::int64_t first, last;
};
Cells cells(double x, double cell, double margin) {
    return {static_cast<std::int64_t>(std::floor((x - margin) / cell)),
            static_cast<std::int64_t>(std::floor((x + margin) / cell))};
}

std::uint64_t hash_cell(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t d) {
    std::uint64_t h = mix(0, static_cast<std::uint64_t>(x));
    h = mix(h, static_cast<std::uint64_t>(y));
    h = mix(h, static_cast<std::uint64_t>(z));
    return mix(h, static_cast<std::uint64_t>(d));
}

}  // namespace

double coincidence_tolerance(double largest_coordinate) {
    return largest_coordinate * kTolerancePerLength;
}

std::uint64_t PlaneTable::cell(const glm::dvec3& normal, double offset) const {
    const auto at = [](double x, double size) { return static_cast<std::int64_t>(std::floor(x / size)); };
    return hash_cell(at(normal.x, kNormalCell), at(normal.y, kNormalCell), at(normal.z, kNormalCell),
                     at(offset, kOffsetCell * length()));
}

double PlaneTable::length() const {
    return tolerance_ > 0 ? tolerance_ / kTolerancePerLength : 1.0;
}

std::uint32_t PlaneTable::find(const Plane& plane, const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c) const {
    if (buckets_.empty())
        return kNone;
    const Cells x = cells(plane.normal.x, kNormalCell, kNormalMargin);
    const Cells y = cells(plane.normal.y, kNormalCell, kNormalMargin);
    const Cells z = cells(plane.normal.z, kNormalCell, kNormalMargin);
    const Cells d = cells(plane.offset, kOffsetCell * length(), kOffsetMargin * length());
    std::uint32_t best = kNone;
    for (std::int64_t i = x.first; i <= x.last; ++i)
        for (std::int64_t j = y.first; j <= y.last; ++j)
            for (std::int64_t k = z.first; k <= z.last; ++k)
                for (std::int64_t l = d.first; l <= d.last; ++l) {
                    std::uint32_t entry = buckets_[hash_cell(i, j, k, l) & (buckets_.size() - 1)];
                    for (; entry != kNone; entry = next_[entry]) {
                        const Plane& known = planes_[entry];
                        if (entry < best && distance(known, a) <= tolerance_ && distance(known, b) <= tolerance_ &&
                            distance(known, c) <= tolerance_ && std::abs(glm::dot(known.normal, plane.normal)) > 0.999)
                            best = entry;
                    }
                }
    return best;
}

void PlaneTable::insert(std::uint32_t entry) {
    std::uint32_t& head = buckets_[cell(planes_[entry].normal, planes_[entry].offset) & (buckets_.size() - 1)];
    next_[entry] = head;
    head = entry;
}

PlaneRef PlaneTable::add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const Plane plane = plane_of(a, b, c);
    std::uint32_t entry = std::min(find(plane, a, b, c), find({-plane.normal, -plane.offset}, a, b, c));
    if (entry == kNone) {
        entry = static_cast<std::uint32_t>(planes_.size());
        planes_.push_back(plane);
        next_.push_back(kNone);
        if (planes_.size() * 2 > buckets_.size()) {
            buckets_.assign(std::max<std::size_t>(64, buckets_.size() * 2), kNone);
            for (std::uint32_t i = 0; i <= entry; ++i)
                insert(i);
        } else {
            insert(entry);
        }
    }
    return {entry, glm::dot(planes_[entry].normal, plane.normal) < 0};
}

}  // namespace csg::solid
