#include "csg/reference/exact_space.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace csg::reference {
namespace {

/// Of the largest coordinate: wide against the rounding of where a ray begins.
constexpr double kMargin = 1e-9;

std::vector<Box> boxes_of(const ExactFaces& faces) {
    std::vector<Box> boxes;
    boxes.reserve(faces.faces.size());
    for (const ExactFace& face : faces.faces) {
        Box box;
        for (std::size_t k = 0; k < 3; ++k) {
            box = enclose(box, faces.corner(face, k));
        }
        const double margin = kMargin * faces.largest;
        boxes.push_back({box.lo - margin, box.hi + margin});
    }
    return boxes;
}

Covers summed(Covers hits) {
    std::sort(hits.begin(), hits.end(), [](const Cover& a, const Cover& b) { return a.leaf < b.leaf; });
    Covers result;
    for (const Cover& hit : hits) {
        if (result.empty() || result.back().leaf != hit.leaf) {
            result.push_back({hit.leaf, 0});
        }
        result.back().count += hit.count;
    }
    std::erase_if(result, [](const Cover& c) { return c.count == 0; });
    return result;
}

/// A segment from a point in a face to beyond everything.
class Ray {
  public:
    Ray(const ExactFaces& faces, const ExactKernel::Point_3& from, const glm::dvec3& to)
        : faces_(faces), from_(from), to_(exact(to)) {}

    /// 1: leaves through the face, -1: enters through it, 0: does not meet it. Nothing where it meets its border.
    [[nodiscard]] std::optional<int> meet(const ExactFace& face) const {
        const auto a = exact(faces_.corner(face, 0)), b = exact(faces_.corner(face, 1)),
                   c = exact(faces_.corner(face, 2));
        const int start = CGAL::orientation(a, b, c, from_), end = CGAL::orientation(a, b, c, to_);
        if (start == 0 || start * end >= 0) {
            return 0;  // In the face's plane it is at its start, which does not count, or beyond everything.
        }
        int least = 1, most = -1;
        for (const int way : {CGAL::orientation(from_, to_, a, b), CGAL::orientation(from_, to_, b, c),
                              CGAL::orientation(from_, to_, c, a)}) {
            least = std::min(least, way);
            most = std::max(most, way);
        }
        if (least < 0 && most > 0) {
            return 0;
        }
        if (least == 0 || most == 0) {
            return {};
        }
        return start < 0 ? 1 : -1;
    }

  private:
    const ExactFaces& faces_;
    ExactKernel::Point_3 from_, to_;
};

}  // namespace

ExactSpace::ExactSpace(const ExactFaces& faces, const ExactPoints& points)
    : faces_(faces),
      points_(points),
      normals_(faces.planes.size()),
      has_normal_(faces.planes.size(), 0),
      boxes_(boxes_of(faces)),
      tree_(boxes_) {}

const ExactKernel::Vector_3& ExactSpace::normal(std::uint32_t plane) const {
    if (has_normal_[plane] == 0) {
        const ExactFace& face = faces_.faces[faces_.planes[plane].face];
        const auto a = exact(faces_.corner(face, 0));
        normals_[plane] = CGAL::cross_product(exact(faces_.corner(face, 1)) - a, exact(faces_.corner(face, 2)) - a);
        has_normal_[plane] = 1;
    }
    return normals_[plane];
}

/// With normals n, m and the edge's direction d, the half-planes' directions are ± n × d and ± m × d, and
/// ((n × d) × (m × d)) · d has the sign of (n × m) · d; n × m is parallel to d, so one axis tells.
int ExactSpace::turn(const Half& a, const Half& b, int axis, int along) const {
    if (a.plane == b.plane) {
        return 0;
    }
    const ExactKernel::Vector_3 &n = normal(a.plane), &m = normal(b.plane);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int way = static_cast<int>(CGAL::compare(n[u] * m[v], n[v] * m[u])) * along;
    return a.left == b.left ? way : -way;
}

void ExactSpace::sort_around(std::span<ComplexSide> sides, std::span<const ComplexCell> cells) const {
    if (sides.size() < 3) {
        return;
    }
    const std::uint32_t lo = sides[0].lo, hi = sides[0].hi;
    const glm::dvec3 size = glm::abs(points_.near(hi) - points_.near(lo));
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int along = 0;
    for (int i = 0; i < 3 && along == 0; ++i) {
        axis = (axis + (i > 0 ? 1 : 0)) % 3;
        along = CGAL::compare(points_[hi][axis], points_[lo][axis]);
    }
    struct Item {
        Half half;
        int quarter;  ///< 0: as the first, 1: before half a turn, 2: half a turn, 3: beyond.
    };
    std::vector<Item> items;
    for (const ComplexSide& side : sides) {
        items.push_back({{cells[side.cell].plane, side.left, side}, 0});
    }
    for (std::size_t i = 1; i < items.size(); ++i) {
        const Half &first = items[0].half, &half = items[i].half;
        if (half.plane == first.plane) {
            items[i].quarter = half.left == first.left ? 0 : 2;
            continue;
        }
        const int way = turn(first, half, axis, along);
        if (way == 0) {
            throw Undecided("two planes at an edge are one");
        }
        items[i].quarter = way > 0 ? 1 : 3;
    }
    std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
        return a.quarter != b.quarter ? a.quarter < b.quarter : turn(a.half, b.half, axis, along) > 0;
    });
    for (std::size_t i = 0; i < items.size(); ++i) {
        sides[i] = items[i].half.side;
    }
}

std::optional<Covers> ExactSpace::windings_above(const ComplexCell& cell) const {
    const auto area = [&](const glm::uvec3& t) {
        const glm::dvec3& a = points_.near(t.x);
        return glm::length(glm::cross(points_.near(t.y) - a, points_.near(t.z) - a));
    };
    const glm::uvec3 t = *std::max_element(cell.triangles.begin(), cell.triangles.end(),
                                           [&](const auto& a, const auto& b) { return area(a) < area(b); });
    const auto from = CGAL::centroid(points_[t.x], points_[t.y], points_[t.z]);
    const glm::dvec3 near = (points_.near(t.x) + points_.near(t.y) + points_.near(t.z)) / 3.0;
    const ExactFace& face = faces_.faces[faces_.planes[cell.plane].face];
    const glm::dvec3 up = glm::normalize(
        glm::cross(faces_.corner(face, 1) - faces_.corner(face, 0), faces_.corner(face, 2) - faces_.corner(face, 0)));
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    for (int attempt = 0; attempt < 1000; ++attempt) {
        glm::dvec3 aside;
        for (int i = 0; i < 3; ++i) {
            aside[i] = number();
        }
        // Beyond everything: no coordinate is larger than `largest`.
        glm::dvec3 way = std::isfinite(up.x + up.y + up.z) ? up + aside : aside;
        way *= 8 * faces_.largest / std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z), 1e-3});
        const glm::dvec3 to = near + way;
        if (CGAL::orientation(exact(faces_.corner(face, 0)), exact(faces_.corner(face, 1)),
                              exact(faces_.corner(face, 2)), exact(to)) != CGAL::POSITIVE) {
            continue;
        }
        const Ray ray(faces_, from, to);
        Covers hits;
        const bool told = tree_.along(near, to - near, [&](std::uint32_t i) {
            const std::optional<int> hit = ray.meet(faces_.faces[i]);
            if (hit.value_or(0) != 0) {
                hits.push_back({faces_.faces[i].leaf, *hit});
            }
            return hit.has_value();
        });
        if (told) {
            return summed(std::move(hits));
        }
    }
    return {};
}

}  // namespace csg::reference
