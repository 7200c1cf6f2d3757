#include "ui/pipeline/inspection/measured.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/pipeline/inspection/triangle_distance.h"

namespace ui {

namespace {

using csg::solid::FormKind;
using csg::solid::PlacedLeaf;

glm::dvec3 normal_of(const Model& model, csg::LeafId leaf, std::uint32_t triangle) {
    const csg::solid::PlaneRef plane = model.geometry.leaves[leaf].planes[triangle];
    const glm::dvec3& normal = model.geometry.planes.planes()[plane.index].normal;
    return plane.flipped ? -normal : normal;
}

std::array<glm::dvec3, 3> corners_of(const PlacedLeaf& leaf, std::uint32_t triangle) {
    const glm::uvec3& t = leaf.triangles[triangle];
    return {leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]};
}

Measured face_of(const Model& model, csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& at) {
    Measured face;
    face.kind = Measured::Kind::Face;
    face.at = at;
    face.form = csg::solid::form_of(*model.tree, model.scene, model.geometry, leaf, triangle);
    face.leaf = leaf;
    return face;
}

double area(const std::array<glm::dvec3, 3>& corners) {
    return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

/// Of all triangles in the plane of one, weighted by their areas.
glm::dvec3 middle_of_plane(const PlacedLeaf& leaf, std::uint32_t triangle) {
    glm::dvec3 sum(0);
    double weight = 0;
    for (std::uint32_t i = 0; i < leaf.triangles.size(); ++i) {
        if (leaf.planes[i].index == leaf.planes[triangle].index) {
            const auto corners = corners_of(leaf, i);
            sum += area(corners) * (corners[0] + corners[1] + corners[2]) / 3.0;
            weight += area(corners);
        }
    }
    return weight > 0 ? sum / weight : corners_of(leaf, triangle)[0];
}

}  // namespace

std::uint32_t triangle_at(const Model& model, const PickedSurface& picked) {
    const PlacedLeaf& leaf = model.geometry.leaves[picked.surface.leaf];
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; i < leaf.triangles.size(); ++i) {
        if (leaf.planes[i].index != picked.surface.plane) {
            continue;
        }
        const double distance =
            nearest_points({picked.point, picked.point, picked.point}, corners_of(leaf, i)).distance;
        if (distance < least) {
            least = distance;
            found = i;
        }
    }
    return found;
}

std::optional<glm::dvec3> Measured::direction() const {
    switch (kind) {
        case Kind::Point:
            return std::nullopt;
        case Kind::Edge:
            return glm::normalize(to - from);
        case Kind::Circle:
            return form.direction;
        case Kind::Face:
            break;
    }
    return form.kind == FormKind::Sphere ? std::nullopt : std::optional(form.direction);
}

std::optional<double> Measured::radius() const {
    const bool round =
        kind == Kind::Circle || (kind == Kind::Face && form.kind != FormKind::Plane && form.kind != FormKind::Cone);
    return round ? std::optional(form.radius) : std::nullopt;
}

Measured measured_point(const glm::dvec3& point) {
    Measured result;
    result.at = point;
    return result;
}

Measured measured_face(const Model& model, const PickedSurface& picked) {
    Measured face = face_of(model, picked.surface.leaf, triangle_at(model, picked), picked.point);
    if (face.form.kind == FormKind::Plane) {
        face.form.direction = picked.normal;
    }
    return face;
}

Measured measured_face(const Model& model, csg::LeafId leaf, const glm::dvec3& towards) {
    const PlacedLeaf& placed = model.geometry.leaves[leaf];
    constexpr double kAlike = 1e-9;
    double best = -std::numeric_limits<double>::infinity(), largest = 0;
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; i < placed.triangles.size(); ++i) {
        const double facing = glm::dot(normal_of(model, leaf, i), glm::normalize(towards));
        const double size = area(corners_of(placed, i));
        if (facing > best + kAlike || (facing > best - kAlike && size > largest)) {
            best = std::max(best, facing);
            largest = size;
            found = i;
        }
    }
    return face_of(model, leaf, found, middle_of_plane(placed, found));
}

std::optional<Measured> measured_round(const Model& model, csg::LeafId leaf) {
    const PlacedLeaf& placed = model.geometry.leaves[leaf];
    const auto groups = csg::solid::groups_of(placed);
    std::optional<Measured> found;
    std::optional<std::uint32_t> surface;
    for (std::uint32_t i = 0; i < placed.triangles.size() && i < groups.size(); ++i) {
        if (groups[i].bend() == 0 || groups[i].surface() == surface) {
            continue;
        }
        if (surface) {
            return std::nullopt;
        }
        surface = groups[i].surface();
        found = face_of(model, leaf, i, corners_of(placed, i)[0]);
        if (found->form.kind != FormKind::Plane) {
            found->at = found->form.point;
        }
    }
    return found;
}

}  // namespace ui
