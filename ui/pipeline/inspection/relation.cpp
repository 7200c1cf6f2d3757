// Distances and angles between points, straight lines and planes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/pipeline/inspection/measured.h"

namespace ui {

namespace {

using csg::solid::FormKind;

/// What a thing counts as.
struct Locus {
    enum class Kind { Point, Segment, Line, Plane };
    Kind kind = Kind::Point;
    glm::dvec3 point{0.0}, end{0.0}, direction{0.0};
    double radius = 0;  ///< Of what is round about it.
};

Locus locus_of(const Measured& thing) {
    const csg::solid::SurfaceForm& form = thing.form;
    switch (thing.kind) {
        case Measured::Kind::Point:
            return {Locus::Kind::Point, thing.at};
        case Measured::Kind::Edge:
            return {Locus::Kind::Segment, thing.from, thing.to, glm::normalize(thing.to - thing.from)};
        case Measured::Kind::Circle:
            return {Locus::Kind::Point, form.point, {}, form.direction};
        case Measured::Kind::Face:
            break;
    }
    switch (form.kind) {
        case FormKind::Plane:
            return {Locus::Kind::Plane, form.point, {}, form.direction};
        case FormKind::Cylinder:
            return {Locus::Kind::Line, form.point, {}, form.direction, form.radius};
        case FormKind::Cone:
            return {Locus::Kind::Line, form.point, {}, form.direction};
        case FormKind::Sphere:
            return {Locus::Kind::Point, form.point, {}, {}, form.radius};
        case FormKind::Torus:
            return {Locus::Kind::Point, form.point, {}, form.direction};
    }
    return {};
}

constexpr double kParallel = 1e-9;  ///< Sine of an angle that is none.

using PointPair = std::pair<glm::dvec3, glm::dvec3>;

/// The share of the way along `l` that it may be gone, where it has ends.
double on(const Locus& l, double t) {
    return l.kind == Locus::Kind::Segment ? std::clamp(t, 0.0, glm::distance(l.point, l.end)) : t;
}

glm::dvec3 foot(const Locus& l, const glm::dvec3& p) {
    return l.point + on(l, glm::dot(p - l.point, l.direction)) * l.direction;
}

/// The nearest points of two straight lines, with ends or without (Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.9).
PointPair nearest(const Locus& a, const Locus& b) {
    const glm::dvec3 apart = a.point - b.point;
    const double cosine = glm::dot(a.direction, b.direction), square = 1 - cosine * cosine;
    const double da = glm::dot(a.direction, apart), db = glm::dot(b.direction, apart);
    double t = 0;
    if (square > kParallel * kParallel) {
        t = on(a, (cosine * db - da) / square);
    } else if (a.kind == Locus::Kind::Line && b.kind == Locus::Kind::Line) {
        t = -da;  // Beside the other's point.
    } else if (b.kind == Locus::Kind::Segment) {
        const double first = -da, second = glm::dot(b.end - a.point, a.direction);
        const double low = std::min(first, second), high = std::max(first, second);
        t = a.kind == Locus::Kind::Line
                ? first
                : std::clamp(std::clamp((low + high) / 2, low, high), 0.0, glm::distance(a.point, a.end));
    }
    const glm::dvec3 q = foot(b, a.point + t * a.direction);
    return {foot(a, q), q};
}

/// Of a plane and something else, that first: the points where they are nearest, where they do not cross.
std::optional<PointPair> beside_plane(const Locus& l, const Locus& plane) {
    const auto project = [&](const glm::dvec3& p) {
        return PointPair(p, p - glm::dot(p - plane.point, plane.direction) * plane.direction);
    };
    const double slope = std::abs(glm::dot(l.direction, plane.direction));
    switch (l.kind) {
        case Locus::Kind::Point:
            return project(l.point);
        case Locus::Kind::Line:
            return slope < kParallel ? std::optional(project(l.point)) : std::nullopt;
        case Locus::Kind::Plane:
            return glm::length(glm::cross(l.direction, plane.direction)) < kParallel ? std::optional(project(l.point))
                                                                                     : std::nullopt;
        case Locus::Kind::Segment:
            break;
    }
    const double from = glm::dot(l.point - plane.point, plane.direction),
                 to = glm::dot(l.end - plane.point, plane.direction);
    if ((from < 0) != (to < 0) && slope >= kParallel) {
        const glm::dvec3 met = l.point + from / (from - to) * (l.end - l.point);
        return PointPair(met, met);
    }
    return project(std::abs(from) <= std::abs(to) ? l.point : l.end);
}

std::optional<PointPair> nearest_places(const Locus& a, const Locus& b) {
    if (b.kind == Locus::Kind::Plane) {
        return beside_plane(a, b);
    }
    if (a.kind == Locus::Kind::Plane) {
        auto found = beside_plane(b, a);
        return found ? std::optional(PointPair(found->second, found->first)) : std::nullopt;
    }
    if (a.kind == Locus::Kind::Point) {
        return PointPair(a.point, b.kind == Locus::Kind::Point ? b.point : foot(b, a.point));
    }
    if (b.kind == Locus::Kind::Point) {
        return PointPair(foot(a, b.point), b.point);
    }
    return nearest(a, b);
}

/// Degrees between two directions, or planes by their normals; of a direction and a plane between it and the plane.
double degrees_between(const Locus& a, const Locus& b) {
    const double sine = glm::length(glm::cross(a.direction, b.direction)),
                 cosine = std::abs(glm::dot(a.direction, b.direction));
    const bool one_plane = (a.kind == Locus::Kind::Plane) != (b.kind == Locus::Kind::Plane);
    return glm::degrees(one_plane ? std::atan2(cosine, sine) : std::atan2(sine, cosine));
}

}  // namespace

Relation relation_of(const Measured& a, const Measured& b) {
    const Locus l = locus_of(a), m = locus_of(b);
    Relation relation;
    if (a.direction() && b.direction()) {
        relation.degrees = degrees_between(l, m);
        relation.parallel = *relation.degrees < glm::degrees(kParallel);
    }
    const auto places = nearest_places(l, m);
    if (!places) {
        return relation;
    }
    relation.from = places->first;
    relation.to = places->second;
    relation.distance = glm::distance(places->first, places->second);
    const double round = l.radius + m.radius;
    const bool crossing = l.kind == Locus::Kind::Line && m.kind == Locus::Kind::Line && !relation.parallel;
    if (round > 0 && !crossing) {
        relation.most = *relation.distance + round;
        if (*relation.distance >= round) {
            relation.least = *relation.distance - round;
        }
    }
    return relation;
}

}  // namespace ui
