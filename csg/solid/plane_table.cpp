#include "csg/solid/plane_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "csg/solid/no_index.h"
#include "csg/tree/hash.h"

namespace csg::solid {
namespace {

constexpr double kTolerancePerLength = 0x1p-33;
/// Cells of the hash: wide against the tolerance, narrow against the distance of unrelated planes.
constexpr double kNormalCell = 1e-3, kNormalMargin = 1e-6;
constexpr double kOffsetCell = 1e-4, kOffsetMargin = 2e-6;  // per unit of the largest coordinate

Plane opposite(const Plane& plane) {
    return {-plane.normal, -plane.offset};
}

double distance(const Plane& plane, const glm::dvec3& p) {
    return std::abs(glm::dot(plane.normal, p) - plane.offset);
}

/// The next whole number below, as std::floor, which is a call where the processor is not known to have SSE 4.1.
std::int64_t floor_of(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

/// The cells that a value within `margin` of x can lie in: one or two.
struct Cells {
    std::int64_t first, last;
};
Cells cells(double x, double cell, double margin) {
    return {floor_of((x - margin) / cell), floor_of((x + margin) / cell)};
}

}  // namespace

Plane plane_through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    if (length > 0 && std::isfinite(length)) {
        const glm::dvec3 normal = n / length;
        return {normal, glm::dot(normal, a)};
    }
    glm::dvec3 edge = b - a;
    for (const glm::dvec3& e : {c - b, a - c}) {
        if (glm::dot(e, e) > glm::dot(edge, edge)) {
            edge = e;
        }
    }
    const glm::dvec3 across =
        std::abs(edge.x) < std::abs(edge.z) ? glm::cross(edge, {1, 0, 0}) : glm::cross(edge, {0, 0, 1});
    const double size = glm::length(across);
    const glm::dvec3 normal = size > 0 && std::isfinite(size) ? across / size : glm::dvec3(0, 0, 1);
    return {normal, glm::dot(normal, a)};
}

double coincidence_tolerance(double largest_coordinate) {
    return largest_coordinate * kTolerancePerLength;
}

std::uint64_t PlaneTable::Cell::hash() const {
    std::uint64_t h = mix(0, static_cast<std::uint64_t>(x));
    h = mix(h, static_cast<std::uint64_t>(y));
    h = mix(h, static_cast<std::uint64_t>(z));
    return mix(h, static_cast<std::uint64_t>(d));
}

PlaneTable::Cell PlaneTable::cell(const Plane& plane) const {
    const auto at = [](double x, double size) { return floor_of(x / size); };
    return {at(plane.normal.x, kNormalCell), at(plane.normal.y, kNormalCell), at(plane.normal.z, kNormalCell),
            at(plane.offset, kOffsetCell * length())};
}

double PlaneTable::length() const {
    return tolerance_ > 0 ? tolerance_ / kTolerancePerLength : 1.0;
}

bool PlaneTable::close(const Plane& known, const Plane& own, const glm::dvec3& a, const glm::dvec3& b,
                       const glm::dvec3& c) const {
    return distance(known, a) <= tolerance_ && distance(known, b) <= tolerance_ && distance(known, c) <= tolerance_ &&
           std::abs(glm::dot(known.normal, own.normal)) > 0.999;
}

template <typename Visit>
void PlaneTable::for_each_in_cell(std::uint64_t hash, const Visit& visit) const {
    for (std::uint32_t entry = buckets_[hash & (buckets_.size() - 1)]; entry != kNone; entry = next_[entry]) {
        if (hashes_[entry] == hash) {
            visit(entry);
        }
    }
}

template <typename Visit>
void PlaneTable::for_each_in_cells(const Plane& plane, const Visit& visit) const {
    if (buckets_.empty()) {
        return;
    }
    const Cells x = cells(plane.normal.x, kNormalCell, kNormalMargin);
    const Cells y = cells(plane.normal.y, kNormalCell, kNormalMargin);
    const Cells z = cells(plane.normal.z, kNormalCell, kNormalMargin);
    const Cells d = cells(plane.offset, kOffsetCell * length(), kOffsetMargin * length());
    for (std::int64_t i = x.first; i <= x.last; ++i) {
        for (std::int64_t j = y.first; j <= y.last; ++j) {
            for (std::int64_t k = z.first; k <= z.last; ++k) {
                for (std::int64_t l = d.first; l <= d.last; ++l) {
                    for_each_in_cell(Cell{i, j, k, l}.hash(), visit);
                }
            }
        }
    }
}

void PlaneTable::link(std::uint32_t entry) {
    std::uint32_t& head = buckets_[hashes_[entry] & (buckets_.size() - 1)];
    next_[entry] = head;
    head = entry;
}

void PlaneTable::rehash(std::size_t buckets) {
    buckets_.assign(buckets, kNone);
    for (std::uint32_t i = 0; i < planes_.size(); ++i) {
        if (next_[i] != i) {
            link(i);
        }
    }
}

PlaneRef PlaneTable::add(const Plane& plane, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    std::uint32_t entry = kNone;
    const auto take = [&](std::uint32_t known) {
        if (known < entry && close(planes_[known], plane, a, b, c)) {
            entry = known;
        }
    };
    for_each_in_cells(plane, take);
    for_each_in_cells(opposite(plane), take);
    if (entry == kNone) {
        entry = static_cast<std::uint32_t>(planes_.size());
        fill_hole(entry, plane);
    }
    return {entry, glm::dot(planes_[entry].normal, plane.normal) < 0};
}

void PlaneTable::find_all(const Plane& plane, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                          std::vector<std::uint32_t>& found) const {
    const auto take = [&](std::uint32_t known) {
        if (close(planes_[known], plane, a, b, c)) {
            found.push_back(known);
        }
    };
    for_each_in_cells(plane, take);
    for_each_in_cells(opposite(plane), take);
}

/// What a triangle looks at is one cell or two along each axis: the entries that it can share lie in cells next to each
/// other, or in such as mirror these.
void PlaneTable::find_near(const Plane& plane, std::vector<std::uint32_t>& found) const {
    if (buckets_.empty()) {
        return;
    }
    const auto take = [&](std::uint32_t entry) { found.push_back(entry); };
    const Cell at = cell(plane);
    for (const Cell& middle : {at, Cell{-1 - at.x, -1 - at.y, -1 - at.z, -1 - at.d}}) {
        for (int i = 0; i < 81; ++i) {
            for_each_in_cell(
                Cell{middle.x + i % 3 - 1, middle.y + i / 3 % 3 - 1, middle.z + i / 9 % 3 - 1, middle.d + i / 27 - 1}
                    .hash(),
                take);
        }
    }
}

bool PlaneTable::shares(const Plane& entry, const Plane& own, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c) const {
    const Cell at = cell(entry);
    const auto looks_at = [&](const Plane& plane) {
        const auto in = [](const Cells& range, std::int64_t i) { return range.first <= i && i <= range.last; };
        return in(cells(plane.normal.x, kNormalCell, kNormalMargin), at.x) &&
               in(cells(plane.normal.y, kNormalCell, kNormalMargin), at.y) &&
               in(cells(plane.normal.z, kNormalCell, kNormalMargin), at.z) &&
               in(cells(plane.offset, kOffsetCell * length(), kOffsetMargin * length()), at.d);
    };
    return close(entry, own, a, b, c) && (looks_at(own) || looks_at(opposite(own)));
}

void PlaneTable::make_hole(std::uint32_t entry) {
    std::uint32_t* at = &buckets_[hashes_[entry] & (buckets_.size() - 1)];
    while (*at != entry) {
        at = &next_[*at];
    }
    *at = next_[entry];
    next_[entry] = entry;
}

void PlaneTable::fill_hole(std::uint32_t entry, const Plane& plane) {
    if (entry == planes_.size()) {
        planes_.emplace_back();
        hashes_.emplace_back();
        next_.push_back(entry);
    }
    planes_[entry] = plane;
    hashes_[entry] = cell(plane).hash();
    if (planes_.size() * 2 > buckets_.size()) {
        next_[entry] = kNone;  // No hole any more.
        rehash(std::max<std::size_t>(64, buckets_.size() * 2));
    } else {
        link(entry);
    }
}

void PlaneTable::drop_last() {
    planes_.pop_back();
    hashes_.pop_back();
    next_.pop_back();
}

void PlaneTable::rearrange(const std::vector<std::uint32_t>& from) {
    std::vector<Plane> planes(from.size());
    std::vector<std::uint64_t> hashes(from.size());
    std::vector<std::uint32_t> next(from.size());
    for (std::uint32_t i = 0; i < from.size(); ++i) {
        planes[i] = planes_[from[i]];
        hashes[i] = hashes_[from[i]];
        next[i] = next_[from[i]] == from[i] ? i : kNone;
    }
    planes_ = std::move(planes);
    hashes_ = std::move(hashes);
    next_ = std::move(next);
    rehash(std::max<std::size_t>(64, std::bit_ceil(2 * planes_.size())));
}

}  // namespace csg::solid
