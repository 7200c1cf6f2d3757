#include "ui/pipeline/inspection/solid_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "ui/pipeline/infinity.h"

namespace ui {

namespace {

using csg::solid::PlacedLeaf;

std::vector<csg::Box> widened(std::vector<csg::Box> boxes, double by) {
    for (csg::Box& box : boxes) {
        box.lo -= by;
        box.hi += by;
    }
    return boxes;
}

std::vector<csg::Box> boxes_of(const csg::solid::Geometry& geometry) {
    std::vector<csg::Box> boxes;
    for (const PlacedLeaf& leaf : geometry.leaves) {
        boxes.push_back(leaf.box.empty() ? csg::Box{glm::dvec3(0), glm::dvec3(0)} : leaf.box);  // Without triangles.
    }
    return boxes;
}

bool before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// On which side of the edge the ray passes: computed in one direction of the edge for both of its triangles, so that
/// just one of them is hit.
bool left_of(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& p, const glm::dvec3& q) {
    const bool forward = before(p, q);
    const glm::dvec3 from = (forward ? p : q) - origin, to = (forward ? q : p) - origin;
    return (glm::dot(direction, glm::cross(from, to)) >= 0) == forward;
}

/// Adds `step` to the leaf's winding number.
void pass(Covers& covers, csg::LeafId leaf, int step) {
    const auto at = std::lower_bound(covers.begin(), covers.end(), leaf,
                                     [](const Cover& cover, csg::LeafId id) { return cover.leaf < id; });
    if (at == covers.end() || at->leaf != leaf) {
        covers.insert(at, {leaf, step});
    } else if ((at->winding += step) == 0) {
        covers.erase(at);
    }
}

double volume(const PlacedLeaf& leaf) {
    double sum = 0;
    const glm::dvec3 origin = leaf.box.empty() ? glm::dvec3(0) : leaf.box.center();
    for (const glm::uvec3& t : leaf.triangles) {
        sum += glm::dot(leaf.points[t.x] - origin, glm::cross(leaf.points[t.y] - origin, leaf.points[t.z] - origin));
    }
    return sum;
}

bool nearer(const Crossing& a, const Crossing& b) {
    return std::tie(a.t, a.leaf, a.triangle) < std::tie(b.t, b.leaf, b.triangle);
}

}  // namespace

SolidProbe::SolidProbe(const csg::Scene& scene, const csg::solid::Geometry& geometry)
    : scene_(scene),
      geometry_(geometry),
      event_(std::max(4 * geometry.planes.tolerance(), 1e-12)),
      leaf_boxes_(widened(boxes_of(geometry), 2 * event_)),
      leaves_(leaf_boxes_),
      leaf_rays_(leaf_boxes_) {
    for (const PlacedLeaf& leaf : geometry.leaves) {
        triangles_.emplace_back(widened(csg::reference::triangle_boxes(leaf.points, leaf.triangles), 2 * event_));
        plain_.push_back(leaf.solid->closed && leaf.solid->simple && volume(leaf) > 0 ? 1 : 0);
    }
}

glm::dvec3 SolidProbe::normal(csg::LeafId leaf, std::uint32_t triangle) const {
    const csg::solid::PlaneRef plane = geometry_.leaves[leaf].planes[triangle];
    const glm::dvec3& n = geometry_.planes.planes()[plane.index].normal;
    return plane.flipped ? -n : n;
}

bool SolidProbe::holds(const Cover& cover) const {
    return geometry_.leaves[cover.leaf].solid->closed ? cover.winding != 0 : cover.winding % 2 != 0;
}

void SolidProbe::inside(const Covers& covers, std::vector<csg::LeafId>& out) const {
    out.clear();
    for (const Cover& cover : covers) {
        if (holds(cover)) {
            out.push_back(cover.leaf);
        }
    }
}

std::optional<Crossing> SolidProbe::crossing(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& origin,
                                             const glm::dvec3& direction, double least, double most) const {
    const PlacedLeaf& placed = geometry_.leaves[leaf];
    const glm::uvec3& t = placed.triangles[triangle];
    const glm::dvec3 &a = placed.points[t.x], &b = placed.points[t.y], &c = placed.points[t.z];
    const csg::solid::Plane& plane = geometry_.planes.planes()[placed.planes[triangle].index];
    const double slope = glm::dot(plane.normal, direction);
    constexpr double kEdgeOn = 1e-9;  // Such a triangle is one of a pair that is passed at the same place.
    const double distance = std::abs(slope) > kEdgeOn ? (plane.offset - glm::dot(plane.normal, origin)) / slope
                                                      : glm::dot(direction, (a + b + c) / 3.0 - origin);
    if (!(distance >= least && distance <= most)) {
        return std::nullopt;
    }
    const bool ab = left_of(origin, direction, a, b);
    if (ab != left_of(origin, direction, b, c) || ab != left_of(origin, direction, c, a)) {
        return std::nullopt;
    }
    // Seen along the ray its corners turn one way or the other: into what it bounds, or out of it.
    return Crossing{distance, leaf, triangle, ab ? -1 : 1};
}

void SolidProbe::sides(const glm::dvec3& point, const glm::dvec3& normal,
                       const std::optional<std::pair<csg::LeafId, std::uint32_t>>& own, Sides& out) const {
    out.front.clear();
    out.behind.clear();
    out.met.clear();
    const glm::dvec3 origin = point - 2 * event_ * normal;
    leaves_.meeting({point, point}, [&](std::uint32_t leaf) {
        if (own && own->first == leaf && plain_[leaf] != 0) {
            out.behind.push_back({leaf, 1});
            out.met.push_back({0, leaf, own->second, -1});
            return;
        }
        int front = 0, here = 0;
        triangles_[leaf].along(origin, normal, kInfinity, [&](std::uint32_t triangle) {
            if (const auto met = crossing(leaf, triangle, point, normal, -event_, kInfinity)) {
                if (met->t > event_) {
                    front -= met->step;
                } else {
                    here += met->step;
                    out.met.push_back(*met);
                }
            }
        });
        if (front != 0) {
            out.front.push_back({leaf, front});
        }
        if (front - here != 0) {
            out.behind.push_back({leaf, front - here});
        }
    });
    const auto by_leaf = [](const Cover& a, const Cover& b) { return a.leaf < b.leaf; };
    std::sort(out.front.begin(), out.front.end(), by_leaf);
    std::sort(out.behind.begin(), out.behind.end(), by_leaf);
    std::sort(out.met.begin(), out.met.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.leaf, a.triangle) < std::tie(b.leaf, b.triangle);
    });
}

void SolidProbe::crossings(const glm::dvec3& origin, const glm::dvec3& direction, double most,
                           std::vector<Crossing>& out) const {
    out.clear();
    leaf_rays_.along(origin, direction, most, [&](std::uint32_t leaf) {
        triangles_[leaf].along(origin, direction, most, [&](std::uint32_t triangle) {
            const auto met = crossing(leaf, triangle, origin, direction, event_, most);
            if (met && met->t > event_) {
                out.push_back(*met);
            }
        });
    });
    std::sort(out.begin(), out.end(), nearer);
}

void SolidProbe::crossings(const glm::dvec3& origin, const glm::dvec3& direction, std::span<const Face> faces,
                           std::vector<Crossing>& out) const {
    out.clear();
    for (const Face& face : faces) {
        const auto met = crossing(face.leaf, face.triangle, origin, direction, event_, kInfinity);
        if (met && met->t > event_) {
            out.push_back(*met);
        }
    }
    std::sort(out.begin(), out.end(), nearer);
}

bool PartRay::passes(std::span<const char> parts, const glm::dvec3& origin, const glm::dvec3& direction) {
    probe_.crossings(origin, direction, kInfinity, crossings_);
    return passes_one(parts);
}

bool PartRay::passes(std::span<const char> parts, const glm::dvec3& origin, const glm::dvec3& direction,
                     std::span<const SolidProbe::Face> faces) {
    probe_.crossings(origin, direction, faces, crossings_);
    return passes_one(parts);
}

bool PartRay::passes_one(std::span<const char> parts) {
    covers_.clear();
    for (std::size_t end = crossings_.size(), begin = end; end > 0; end = begin) {
        for (; begin > 0 && crossings_[begin - 1].t >= crossings_[end - 1].t - probe_.event(); --begin) {
            pass(covers_, crossings_[begin - 1].leaf, -crossings_[begin - 1].step);
        }
        if (!covers_.empty()) {
            const std::vector<csg::PartId>& in = at(covers_).parts();
            if (std::any_of(in.begin(), in.end(), [&](csg::PartId part) { return parts[part] != 0; })) {
                return true;
            }
        }
    }
    return false;
}

const PointValues& PartRay::at(const Covers& covers) {
    probe_.inside(covers, inside_);
    values_.go(inside_);
    return values_;
}

template <typename Until>
std::optional<PartRay::Hit> PartRay::walk(const glm::dvec3& origin, const glm::dvec3& direction, const Covers& covers,
                                          double most, const Until& until) {
    probe_.crossings(origin, direction, most, crossings_);
    covers_ = covers;
    for (std::size_t begin = 0, end = 0; begin < crossings_.size(); begin = end) {
        for (; end < crossings_.size() && crossings_[end].t <= crossings_[begin].t + probe_.event(); ++end) {
            pass(covers_, crossings_[end].leaf, crossings_[end].step);
        }
        if (const auto part = until(at(covers_))) {
            Hit hit;
            hit.part = *part;
            hit.cosine = -1;
            for (std::size_t i = begin; i < end; ++i) {
                const Crossing& crossing = crossings_[i];
                const double cosine = std::abs(glm::dot(probe_.normal(crossing.leaf, crossing.triangle), direction));
                if (probe_.scene().leaves[crossing.leaf].part == *part && cosine > hit.cosine) {
                    hit.distance = crossing.t;
                    hit.cosine = cosine;
                    hit.leaf = crossing.leaf;
                    hit.triangle = crossing.triangle;
                }
            }
            return hit;
        }
    }
    return std::nullopt;
}

std::optional<PartRay::Hit> PartRay::leave(csg::PartId part, const glm::dvec3& origin, const glm::dvec3& direction,
                                           const Covers& covers, double most) {
    return walk(origin, direction, covers, most,
                [&](const PointValues& values) { return values.in_part(part) ? std::nullopt : std::optional(part); });
}

std::optional<PartRay::Hit> PartRay::enter(csg::PartId part, const glm::dvec3& origin, const glm::dvec3& direction,
                                           const Covers& covers, double most) {
    return walk(origin, direction, covers, most,
                [&](const PointValues& values) { return values.in_part(part) ? std::optional(part) : std::nullopt; });
}

std::optional<PartRay::Hit> PartRay::enter(const glm::dvec3& origin, const glm::dvec3& direction, const Covers& covers,
                                           double most) {
    return walk(origin, direction, covers, most, [](const PointValues& values) {
        return values.parts().empty() ? std::nullopt : std::optional(values.parts().front());
    });
}

}  // namespace ui
