#include "csg/reference/segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"
#include "csg/reference/edge_uses.h"

namespace csg::reference {
namespace {

using solid::Plane;

std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// A triangle of a leaf, with what the tests for intersection need.
struct Face {
    std::array<glm::dvec3, 3> corners;
    std::array<std::uint32_t, 3> ids;
    std::uint32_t plane;
    Box box;
};

double tolerance_of(const Box& box) {
    const glm::dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    return 4 * solid::coincidence_tolerance(std::max({largest.x, largest.y, largest.z}));
}

/// The part of a plane's line that a triangle of another plane covers.
struct Interval {
    glm::dvec3 from, to;
    double lo, hi;  ///< Positions along the line.
};

std::optional<Interval> cut(const Face& face, const Plane& plane, const glm::dvec3& along, double tolerance) {
    std::array<double, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = glm::dot(plane.normal, face.corners[i]) - plane.offset;
        if (std::abs(d[i]) <= tolerance) {
            d[i] = 0;
        }
    }
    if (d[0] == 0 && d[1] == 0 && d[2] == 0) {
        return {};
    }
    std::optional<Interval> result;
    const auto take = [&](const glm::dvec3& p) {
        const double t = glm::dot(along, p);
        if (!result) {
            result = Interval{p, p, t, t};
        } else if (t < result->lo) {
            result->from = p, result->lo = t;
        } else if (t > result->hi) {
            result->to = p, result->hi = t;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (d[i] == 0) {
            take(face.corners[i]);
        }
        if ((d[i] < 0 && d[j] > 0) || (d[i] > 0 && d[j] < 0)) {
            // From the end below the plane, so that both triangles at this edge get the same point.
            const std::size_t a = d[i] < 0 ? i : j, b = d[i] < 0 ? j : i;
            take(face.corners[a] + (face.corners[b] - face.corners[a]) * (d[a] / (d[a] - d[b])));
        }
    }
    return result;
}

class Collector {
  public:
    Collector(const LeafGroup& group, const InsideRule& rule, const std::stop_token& stop)
        : group_(group), rule_(rule), paced_(stop), content_(tolerance_of(group.extent)) {}

    Content collect() {
        number_planes();
        for (const solid::PlacedLeaf* leaf : group_.leaves) {
            faces_.push_back(faces_of(*leaf));
        }
        for (LeafId i = 0; i < group_.leaves.size(); ++i) {
            add_borders(i, faces_[i]);
        }
        meet_leaves();
        for (PlaneContent& plane : content_.planes) {
            std::sort(plane.segments.begin(), plane.segments.end());
            plane.segments.erase(std::unique(plane.segments.begin(), plane.segments.end()), plane.segments.end());
        }
        return std::move(content_);
    }

  private:
    void number_planes() {
        std::vector<std::uint32_t> used;
        used.reserve(group_.triangles());
        for (const solid::PlacedLeaf* leaf : group_.leaves) {
            for (const solid::PlaneRef& plane : leaf->planes) {
                used.push_back(plane.index);
            }
        }
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        content_.planes.reserve(used.size());
        for (const std::uint32_t index : used) {
            content_.planes.push_back({index, group_.planes[index], {}, {}});
        }
    }

    [[nodiscard]] std::uint32_t number_of(const solid::PlaneRef& plane) const {
        const auto at = std::lower_bound(content_.planes.begin(), content_.planes.end(), plane.index,
                                         [](const PlaneContent& p, std::uint32_t index) { return p.index < index; });
        return static_cast<std::uint32_t>(at - content_.planes.begin());
    }

    std::vector<Face> faces_of(const solid::PlacedLeaf& leaf) {
        std::vector<std::uint32_t> ids;
        ids.reserve(leaf.points.size());
        for (const glm::dvec3& p : leaf.points) {
            paced_();
            ids.push_back(content_.points.add(p));
        }
        std::vector<Face> faces;
        faces.reserve(leaf.triangles.size());
        for (std::size_t i = 0; i < leaf.triangles.size(); ++i) {
            paced_();
            const glm::uvec3& t = leaf.triangles[i];
            Face face{{}, {ids[t.x], ids[t.y], ids[t.z]}, number_of(leaf.planes[i]), {}};
            for (std::size_t k = 0; k < 3; ++k) {
                face.corners[k] = content_.points[face.ids[k]];
                face.box = enclose(face.box, face.corners[k]);
            }
            face.box.lo -= content_.points.tolerance();
            face.box.hi += content_.points.tolerance();
            if (face.ids[0] != face.ids[1] && face.ids[1] != face.ids[2] && face.ids[2] != face.ids[0]) {
                faces.push_back(face);
            } else if (leaf.points[t.x] != leaf.points[t.y] && leaf.points[t.y] != leaf.points[t.z] &&
                       leaf.points[t.z] != leaf.points[t.x]) {
                throw Undecided("a face is smaller than the tolerance");
            }
        }
        return faces;
    }

    /// Edges that the leaf's triangles in a plane do not pass in both directions alike.
    void add_borders(LeafId leaf, const std::vector<Face>& faces) {
        std::vector<EdgeUse> uses;
        uses.reserve(3 * faces.size());
        for (const Face& face : faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                uses.push_back(edge_use(face.ids[k], face.ids[(k + 1) % 3], face.plane));
            }
        }
        visit_borders(uses, leaf, rule_, [&](std::uint32_t lo, std::uint32_t hi, std::uint32_t at, std::int32_t count) {
            const std::uint32_t segment = content_.segments.add(lo, hi);
            PlaneContent& plane = content_.planes[at];
            plane.segments.push_back(segment);
            if (count != 0) {
                plane.borders.push_back({segment, leaf, count});
            }
        });
    }

    void meet_leaves() {
        const double margin = content_.points.tolerance();
        std::vector<Box> boxes;
        boxes.reserve(group_.leaves.size());
        for (std::size_t i = 0; i < group_.leaves.size(); ++i) {
            const Box& box = group_.leaves[i]->box;
            boxes.push_back({box.lo - margin, box.hi + margin});
            if (!group_.leaves[i]->solid->convex) {
                meet(faces_[i], faces_[i], boxes[i], true);
            }
        }
        BoxTree(boxes).pairs([&](std::uint32_t i, std::uint32_t j) {
            paced_();
            meet(faces_[std::min(i, j)], faces_[std::max(i, j)], intersect(boxes[i], boxes[j]), false);
        });
    }

    static std::vector<const Face*> within(const std::vector<Face>& faces, const Box& box) {
        std::vector<const Face*> found;
        for (const Face& face : faces) {
            if (!intersect(face.box, box).empty()) {
                found.push_back(&face);
            }
        }
        return found;
    }

    void meet(const std::vector<Face>& first, const std::vector<Face>& second, const Box& box, bool same) {
        std::vector<const Face*> a = within(first, box), b = within(second, box);
        if (a.empty() || b.empty()) {
            return;
        }
        std::vector<Box> boxes;
        boxes.reserve(b.size());
        for (const Face* face : b) {
            boxes.push_back(face->box);
        }
        const BoxTree tree(boxes);
        if (same) {
            tree.pairs([&](std::uint32_t i, std::uint32_t j) {
                paced_();
                meet(*a[std::min(i, j)], *a[std::max(i, j)], true);
            });
            return;
        }
        for (const Face* face : a) {
            tree.meeting(face->box, [&](std::uint32_t j) {
                paced_();
                meet(*face, *b[j], false);
            });
        }
    }

    void meet(const Face& a, const Face& b, bool same) {
        if (a.plane == b.plane || intersect(a.box, b.box).empty()) {
            return;
        }
        // Neighbors meet in their edge; faces with one corner in common may cross from there on.
        if (same && std::count_if(a.ids.begin(), a.ids.end(), [&](std::uint32_t id) {
                        return std::find(b.ids.begin(), b.ids.end(), id) != b.ids.end();
                    }) > 1) {
            return;
        }
        const Plane &p = content_.planes[a.plane].plane, &q = content_.planes[b.plane].plane;
        const double tolerance = content_.points.tolerance();
        glm::dvec3 along = glm::cross(p.normal, q.normal);
        const double length = glm::length(along);
        if (length < 1e-12) {
            return;
        }
        along /= length;
        const auto on_a = cut(a, q, along, tolerance);
        if (!on_a) {
            return;
        }
        const auto on_b = cut(b, p, along, tolerance);
        if (!on_b || std::min(on_a->hi, on_b->hi) - std::max(on_a->lo, on_b->lo) <= tolerance) {
            return;
        }
        const std::uint32_t from = content_.points.add(on_a->lo >= on_b->lo ? on_a->from : on_b->from);
        const std::uint32_t to = content_.points.add(on_a->hi <= on_b->hi ? on_a->to : on_b->to);
        if (from == to) {
            return;
        }
        const std::uint32_t segment = content_.segments.add(from, to);
        content_.planes[a.plane].segments.push_back(segment);
        content_.planes[b.plane].segments.push_back(segment);
    }

    const LeafGroup& group_;
    const InsideRule& rule_;
    base::PacedStop paced_;
    std::vector<std::vector<Face>> faces_;  ///< By leaf.
    Content content_;
};

}  // namespace

std::uint32_t SegmentTable::add(std::uint32_t a, std::uint32_t b) {
    const auto [entry, added] = by_ends_.try_emplace(key(a, b), static_cast<std::uint32_t>(segments_.size()));
    if (added) {
        segments_.push_back({std::min(a, b), std::max(a, b), {}});
    }
    return entry->second;
}

std::vector<std::uint32_t> SegmentTable::chain(std::uint32_t id, const PointTable& points) const {
    const Segment& s = segments_[id];
    if (s.splits.empty()) {
        return {s.from, s.to};
    }
    const glm::dvec3 along = points[s.to] - points[s.from];
    std::vector<std::uint32_t> inner;
    for (const std::uint32_t p : s.splits) {
        if (p != s.from && p != s.to) {
            inner.push_back(p);
        }
    }
    std::sort(inner.begin(), inner.end());
    inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
    std::sort(inner.begin(), inner.end(),
              [&](auto a, auto b) { return glm::dot(points[a], along) < glm::dot(points[b], along); });
    inner.insert(inner.begin(), s.from);
    inner.push_back(s.to);
    return inner;
}

Content collect_segments(const LeafGroup& group, const InsideRule& rule, const std::stop_token& stop) {
    return Collector(group, rule, stop).collect();
}

}  // namespace csg::reference
