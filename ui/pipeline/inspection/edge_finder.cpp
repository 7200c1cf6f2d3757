// Edges of what a model shows. Rays run from a place of a face in its plane, just below and just above it: where they
// leave the part or enter it, the face ends, at the line where its plane meets that of the face there. From a point of
// that line four rays run along it, in the corners between the two planes: where one of them comes out or in, the edge
// ends.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "ui/pipeline/inspection/measured.h"

namespace ui {

namespace {

using csg::solid::FormKind;
using csg::solid::Plane;

/// How far beside faces rays run, by how far two places that are one may be apart.
constexpr double kBeside = 64;

struct Line {
    glm::dvec3 point, direction;
    [[nodiscard]] glm::dvec3 nearest(const glm::dvec3& p) const {
        return point + glm::dot(p - point, direction) * direction;
    }
};

std::optional<Line> line_of(const Plane& a, const Plane& b) {
    const glm::dvec3 along = glm::cross(a.normal, b.normal);
    const double square = glm::dot(along, along);
    constexpr double kParallel = 1e-10;
    if (square < kParallel) {
        return std::nullopt;
    }
    const glm::dvec3 point = glm::cross(a.offset * b.normal - b.offset * a.normal, along) / square;
    return Line{point, along / std::sqrt(square)};
}

/// In one part of a model.
class Walker {
  public:
    Walker(const SolidProbe& probe, const ExpressionLinks& links, csg::PartId part, double most)
        : probe_(probe), ray_(probe, links), part_(part), most_(most), beside_(kBeside * probe.event()) {}

    [[nodiscard]] double beside() const { return beside_; }
    [[nodiscard]] bool in_part(const glm::dvec3& point) {
        probe_.sides(point, kAny, sides_);
        return ray_.at(sides_.front).in_part(part_);
    }
    /// Where a ray leaves the part, or enters it.
    [[nodiscard]] std::optional<PartRay::Hit> change(const glm::dvec3& from, const glm::dvec3& direction) {
        const bool inside = in_part(from);
        return inside ? ray_.leave(part_, from, direction, sides_.front, most_)
                      : ray_.enter(part_, from, direction, sides_.front, most_);
    }
    [[nodiscard]] const Plane& plane(const PartRay::Hit& hit) const {
        const auto& leaf = probe_.geometry().leaves[hit.leaf];
        return probe_.geometry().planes.planes()[leaf.planes[hit.triangle].index];
    }
    /// Where the edge between two planes that `line` lies in ends, from a point of it on.
    [[nodiscard]] glm::dvec3 end(const Line& line, const Plane& a, const Plane& b, const glm::dvec3& from,
                                 double sign) {
        const double cosine = glm::dot(a.normal, b.normal), square = 1 - cosine * cosine;
        const glm::dvec3 to_a = (a.normal - cosine * b.normal) / square, to_b = (b.normal - cosine * a.normal) / square;
        const glm::dvec3 along = sign * line.direction;
        std::optional<PartRay::Hit> first;
        for (const auto& [x, y] :
             {std::pair(1.0, 1.0), std::pair(1.0, -1.0), std::pair(-1.0, 1.0), std::pair(-1.0, -1.0)}) {
            const auto hit = change(from + beside_ * (x * to_a + y * to_b), along);
            if (hit && (!first || hit->distance < first->distance)) {
                first = hit;
            }
        }
        if (!first) {
            return from + most_ * along;
        }
        const Plane& third = plane(*first);
        const double slope = glm::dot(third.normal, along);
        constexpr double kAlong = 1e-6;
        return std::abs(slope) < kAlong ? from + first->distance * along
                                        : from + (third.offset - glm::dot(third.normal, from)) / slope * along;
    }

  private:
    static constexpr glm::dvec3 kAny{0.48, 0.6, 0.64};  ///< Across no face that people draw.
    const SolidProbe& probe_;
    PartRay ray_;
    csg::PartId part_;
    double most_, beside_;
    SolidProbe::Sides sides_;
};

/// Of a straight edge.
double distance_to(const Measured& edge, const glm::dvec3& p) {
    const glm::dvec3 way = edge.to - edge.from;
    const double share = std::clamp(glm::dot(p - edge.from, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(edge.from + share * way - p);
}

/// The circle in which a plane cuts a sphere.
std::optional<csg::solid::SurfaceForm> circle_of_sphere(const csg::solid::SurfaceForm& flat,
                                                        const csg::solid::SurfaceForm& sphere) {
    const double along = glm::dot(flat.point - sphere.point, flat.direction);
    if (std::abs(along) >= sphere.radius) {
        return std::nullopt;
    }
    csg::solid::SurfaceForm circle = sphere;
    circle.point = sphere.point + along * flat.direction;
    circle.direction = flat.direction;
    circle.radius = std::sqrt(sphere.radius * sphere.radius - along * along);
    circle.segments = 0;
    return circle;
}

/// The circle in which a plane ends a sphere, or a cylinder or a cone across its axis.
std::optional<csg::solid::SurfaceForm> circle_of(const csg::solid::SurfaceForm& a, const csg::solid::SurfaceForm& b) {
    const auto& [flat, round] = a.kind == FormKind::Plane ? std::tie(a, b) : std::tie(b, a);
    if (flat.kind == FormKind::Plane && round.kind == FormKind::Sphere) {
        return circle_of_sphere(flat, round);
    }
    constexpr double kAcross = 1 - 1e-12;
    if (flat.kind != FormKind::Plane || (round.kind != FormKind::Cylinder && round.kind != FormKind::Cone) ||
        std::abs(glm::dot(flat.direction, round.direction)) < kAcross) {
        return std::nullopt;
    }
    csg::solid::SurfaceForm circle = round;
    const double along = glm::dot(flat.point - round.point, round.direction);
    circle.point = round.point + along * round.direction;
    circle.radius = round.kind == FormKind::Cylinder ? round.radius : std::abs(along) * std::tan(round.half_angle);
    return circle;
}

}  // namespace

EdgeFinder::EdgeFinder(const Model& model) : model_(model), links_(model.scene), probe_(model.scene, model.geometry) {}

std::vector<Measured> EdgeFinder::edges(const PickedSurface& picked) const {
    const csg::solid::Geometry& geometry = model_.geometry;
    Walker walker(probe_, links_, picked.part, 2 * geometry.box.diagonal());
    const Plane& plane = geometry.planes.planes()[picked.surface.plane];
    const std::uint32_t triangle = triangle_at(model_, picked);
    const auto form_at = [&](csg::LeafId leaf, std::uint32_t i) {
        return csg::solid::form_of(*model_.tree, model_.scene, geometry, leaf, i);
    };
    const csg::solid::SurfaceForm form = form_at(picked.surface.leaf, triangle);
    const auto smooth = [&](const PartRay::Hit& hit) {
        const auto groups = csg::solid::groups_of(geometry.leaves[hit.leaf]);
        return hit.leaf == picked.surface.leaf && !groups.empty() &&
               csg::solid::smooth_between(groups[triangle], groups[hit.triangle]);
    };
    // Along the axis of what is bent, so that its ends are met.
    const glm::dvec3 axis = form.kind == FormKind::Plane
                                ? (std::abs(plane.normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))
                                : form.direction;
    const glm::dvec3 v = glm::normalize(glm::cross(plane.normal, axis)), u = glm::cross(v, plane.normal);
    struct Found {
        Measured edge;
        double distance;
    };
    std::vector<Found> found;
    std::vector<const Plane*> known;
    constexpr int kDirections = 64;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * std::numbers::pi * i / kDirections;
        const glm::dvec3 direction = std::cos(angle) * u + std::sin(angle) * v;
        std::optional<PartRay::Hit> nearest;
        for (const double side : {-1.0, 1.0}) {
            const auto hit = walker.change(picked.point + side * walker.beside() * picked.normal, direction);
            if (hit && (!nearest || hit->distance < nearest->distance)) {
                nearest = hit;
            }
        }
        if (!nearest || smooth(*nearest)) {
            continue;
        }
        const Plane& other = walker.plane(*nearest);
        const auto line = line_of(plane, other);
        if (!line || std::find(known.begin(), known.end(), &other) != known.end()) {
            continue;
        }
        known.push_back(&other);
        Measured edge;
        edge.at = picked.point;
        edge.leaf = picked.surface.leaf;
        const auto other_form = form_at(nearest->leaf, nearest->triangle);
        if (const auto circle = circle_of(form, other_form)) {
            edge.kind = Measured::Kind::Circle;
            edge.form = *circle;
            found.push_back({edge, nearest->distance});  // Of what may be an arc no more is known.
        } else {
            const glm::dvec3 on = line->nearest(picked.point + nearest->distance * direction);
            edge.kind = Measured::Kind::Edge;
            edge.from = walker.end(*line, plane, other, on, -1);
            edge.to = walker.end(*line, plane, other, on, 1);
            found.push_back({edge, distance_to(edge, picked.point)});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.distance < b.distance; });
    std::vector<Measured> edges;
    edges.reserve(found.size());
    for (const Found& each : found) {
        edges.push_back(each.edge);
    }
    return edges;
}

std::optional<Measured> EdgeFinder::edge(const PickedSurface& picked) const {
    const std::vector<Measured> found = edges(picked);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<Measured> EdgeFinder::corner(const PickedSurface& picked) const {
    std::optional<Measured> best;
    for (const Measured& edge : edges(picked)) {
        if (edge.kind != Measured::Kind::Edge) {
            continue;
        }
        for (const glm::dvec3& end : {edge.from, edge.to}) {
            if (!best || glm::distance(end, picked.point) < glm::distance(best->at, picked.point)) {
                best = measured_point(end);
                best->leaf = edge.leaf;
            }
        }
    }
    return best;
}

}  // namespace ui
