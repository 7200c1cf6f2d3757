#include "csg/reference/exact_faces.h"

#include <algorithm>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"
#include "csg/reference/disjoint_sets.h"
#include "csg/reference/exact_points.h"

namespace csg::reference {
namespace {

/// Of the largest coordinate: a few units in the last place.
constexpr double kRounding = 0x1p-51;

DoubleKernel::Point_3 to_point(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

int turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int u, int v) {
    using Point = DoubleKernel::Point_2;
    return CGAL::orientation(Point(a[u], a[v]), Point(b[u], b[v]), Point(c[u], c[v]));
}

std::size_t count_shared(const ExactFace& a, const ExactFace& b) {
    return static_cast<std::size_t>(std::count_if(a.corners.begin(), a.corners.end(), [&](std::uint32_t corner) {
        return std::find(b.corners.begin(), b.corners.end(), corner) != b.corners.end();
    }));
}

class Collector {
  public:
    Collector(const LeafGroup& group, double largest) : all_{PointTable(largest * kRounding), {}, {}, {}, largest} {
        for (LeafId leaf = 0; leaf < group.leaves.size(); ++leaf) {
            add(leaf, *group.leaves[leaf]);
        }
    }

    ExactFaces collect(const std::stop_token& stop) {
        DisjointSets planes(all_.faces.size());
        base::PacedStop paced(stop);
        const auto visit = [&](std::uint32_t i, std::uint32_t j) {
            paced();
            const ExactFace &a = all_.faces[i], &b = all_.faces[j];
            const auto [b_least, b_most] = sides(a, b);
            if (b_least == 0 && b_most == 0) {
                planes.unite(std::max(i, j), std::min(i, j));
            }
            // Neighbors in a leaf meet in their edge, which is known to both. One of another leaf may end in the
            // middle of what is one face, where a diagonal between two of its triangles is.
            else if (b_least <= 0 && b_most >= 0 && (a.leaf != b.leaf || count_shared(a, b) < 2)) {
                if (const auto [least, most] = sides(b, a); least <= 0 && most >= 0) {
                    all_.meeting.emplace_back(std::min(i, j), std::max(i, j));
                }
            }
        };
        BoxTree(boxes_).pairs(visit);
        std::sort(all_.meeting.begin(), all_.meeting.end());
        number_planes(planes);
        return std::move(all_);
    }

  private:
    void add(LeafId leaf, const solid::PlacedLeaf& placed) {
        std::vector<std::uint32_t> ids;
        ids.reserve(placed.points.size());
        for (const glm::dvec3& p : placed.points) {
            ids.push_back(all_.corners.add(p));
        }
        for (const glm::uvec3& t : placed.triangles) {
            const ExactFace face{{ids[t.x], ids[t.y], ids[t.z]}, leaf, 0};
            const glm::dvec3 &a = all_.corner(face, 0), &b = all_.corner(face, 1), &c = all_.corner(face, 2);
            if (CGAL::collinear(to_point(a), to_point(b), to_point(c))) {
                continue;
            }
            all_.faces.push_back(face);
            boxes_.push_back(enclose(enclose(enclose(Box(), a), b), c));
        }
    }

    /// The least and the most side of a face's plane that another face's corners are on.
    [[nodiscard]] std::pair<int, int> sides(const ExactFace& face, const ExactFace& other) const {
        int least = 1, most = -1;
        for (const std::uint32_t corner : other.corners) {
            const int side = side_of(all_, face, corner);
            least = std::min(least, side);
            most = std::max(most, side);
        }
        return {least, most};
    }

    void number_planes(DisjointSets& sets) {
        SetNumbers number(sets);
        for (std::uint32_t i = 0; i < all_.faces.size(); ++i) {
            all_.faces[i].plane = number(i);
            if (number.count() > all_.planes.size()) {
                all_.planes.push_back(plane_of(i));
            }
        }
    }

    [[nodiscard]] ExactPlane plane_of(std::uint32_t face) const {
        const ExactFace& f = all_.faces[face];
        const glm::dvec3 &a = all_.corner(f, 0), &b = all_.corner(f, 1), &c = all_.corner(f, 2);
        const glm::dvec3 normal = glm::abs(glm::cross(b - a, c - a));
        const int widest = normal.x >= normal.y && normal.x >= normal.z ? 0 : normal.y >= normal.z ? 1 : 2;
        for (int i = 0; i < 3; ++i) {
            const int u = (widest + i + 1) % 3, v = (widest + i + 2) % 3;
            if (const int way = turn(a, b, c, u, v); way != 0) {
                return way > 0 ? ExactPlane{face, u, v} : ExactPlane{face, v, u};
            }
        }
        return {face, 0, 1};  // not reached: the face has an area
    }

    ExactFaces all_;
    std::vector<Box> boxes_;
};

}  // namespace

ExactFaces collect_faces(const LeafGroup& group, const std::stop_token& stop) {
    double largest = 0;
    for (const solid::PlacedLeaf* leaf : group.leaves) {
        const Box& box = leaf->box;
        const glm::dvec3 most = glm::max(glm::abs(box.lo), glm::abs(box.hi));
        largest = std::max({largest, most.x, most.y, most.z});
    }
    return Collector(group, largest).collect(stop);
}

int side_of(const ExactFaces& all, const ExactFace& face, std::uint32_t corner) {
    if (std::find(face.corners.begin(), face.corners.end(), corner) != face.corners.end()) {
        return 0;
    }
    return CGAL::orientation(to_point(all.corner(face, 0)), to_point(all.corner(face, 1)),
                             to_point(all.corner(face, 2)), to_point(all.corners[corner]));
}

bool holds(const ExactFaces& all, const ExactFace& face, std::uint32_t corner) {
    const ExactPlane& plane = all.planes[face.plane];
    int least = 1, most = -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const int way = turn(all.corner(face, k), all.corner(face, k + 1), all.corners[corner], plane.u, plane.v);
        least = std::min(least, way);
        most = std::max(most, way);
    }
    return least >= 0 || most <= 0;
}

bool pierces(const ExactFaces& all, std::uint32_t from, std::uint32_t to, const ExactFace& face) {
    const auto p = to_point(all.corners[from]), q = to_point(all.corners[to]);
    int least = 1, most = -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const int way = CGAL::orientation(p, q, to_point(all.corner(face, k)), to_point(all.corner(face, k + 1)));
        least = std::min(least, way);
        most = std::max(most, way);
        if (least < 0 && most > 0) {
            return false;
        }
    }
    return true;
}

}  // namespace csg::reference
