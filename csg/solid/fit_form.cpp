// Spheres, cylinders and cones through the corners of facets. Facets of a cylinder and of a cone are tangent to a
// smaller one: their normals end on a circle about the axis, and their planes meet in the apex.
#include <algorithm>
#include <cmath>

#include "csg/solid/surface_form.h"

namespace csg::solid {
namespace {

/// Of the radius: how far corners may be off. Files hold seven digits.
constexpr double kOff = 1e-3;
/// Fewer facets than that lie on many surfaces.
constexpr std::size_t kFewest = 4;

glm::dvec3 mean(const std::vector<glm::dvec3>& points) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : points) {
        sum += p;
    }
    return sum / static_cast<double>(points.size());
}

/// The direction that all normals have the same angle to; nothing where they have none in common.
std::optional<glm::dvec3> axis_of(const std::vector<glm::dvec3>& normals) {
    glm::dvec3 axis(0);
    for (std::size_t i = 1; i + 1 < normals.size(); ++i) {
        const glm::dvec3 across = glm::cross(normals[i] - normals[0], normals[i + 1] - normals[0]);
        axis += glm::dot(across, axis) < 0 ? -across : across;
    }
    const double length = glm::length(axis);
    if (length < 1e-9) {
        return std::nullopt;
    }
    axis /= length;
    const double cosine = glm::dot(axis, mean(normals));
    const bool common = std::all_of(normals.begin(), normals.end(),
                                    [&](const glm::dvec3& n) { return std::abs(glm::dot(axis, n) - cosine) < kOff; });
    return common ? std::optional(axis) : std::nullopt;
}

std::optional<SurfaceForm> within(SurfaceForm form, double size) {
    form.exact = false;
    return std::isfinite(form.deviation) && form.deviation <= kOff * size ? std::optional(std::move(form))
                                                                          : std::nullopt;
}

/// The sphere of least squares of |p|² = 2 c·p + (r² - c²).
std::optional<SurfaceForm> sphere(const std::vector<glm::dvec3>& corners) {
    const glm::dvec3 middle = mean(corners);
    glm::dmat4 sum(0);
    glm::dvec4 right(0);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec4 p(corner - middle, 1);
        sum += glm::outerProduct(p, p);
        right += glm::dot(corner - middle, corner - middle) * p;
    }
    const glm::dvec4 found = glm::inverse(sum) * right;
    SurfaceForm form;
    form.kind = FormKind::Sphere;
    const glm::dvec3 center = glm::dvec3(found) / 2.0;
    form.radius = std::sqrt(found.w + glm::dot(center, center));
    form.point = middle + center;
    for (const glm::dvec3& p : corners) {
        form.deviation = std::max(form.deviation, std::abs(glm::length(p - form.point) - form.radius));
    }
    return within(form, form.radius);
}

/// The circle of least squares across the axis.
std::optional<SurfaceForm> cylinder(const std::vector<glm::dvec3>& corners, const glm::dvec3& axis) {
    const glm::dvec3 middle = mean(corners);
    const glm::dvec3 u =
        glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(axis, u);
    glm::dmat3 sum(0);
    glm::dvec3 right(0);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p(glm::dot(corner - middle, u), glm::dot(corner - middle, v), 1);
        sum += glm::outerProduct(p, p);
        right += (p.x * p.x + p.y * p.y) * p;
    }
    const glm::dvec3 found = glm::inverse(sum) * right;
    const glm::dvec2 center = glm::dvec2(found) / 2.0;
    SurfaceForm form;
    form.kind = FormKind::Cylinder;
    form.direction = axis;
    form.radius = std::sqrt(found.z + glm::dot(center, center));
    form.point = middle + center.x * u + center.y * v;
    for (const glm::dvec3& p : corners) {
        const glm::dvec3 to = p - form.point;
        form.deviation = std::max(form.deviation, std::abs(glm::length(to - glm::dot(to, axis) * axis) - form.radius));
    }
    return within(form, form.radius);
}

/// The apex is the point of least squares of all planes.
std::optional<SurfaceForm> cone(const FacetPatch& patch, const glm::dvec3& axis) {
    glm::dmat3 sum(0);
    glm::dvec3 right(0);
    const glm::dvec3 middle = mean(patch.corners);
    for (std::size_t i = 0; i < patch.normals.size(); ++i) {
        sum += glm::outerProduct(patch.normals[i], patch.normals[i]);
        right += glm::dot(patch.normals[i], patch.on_facets[i] - middle) * patch.normals[i];
    }
    SurfaceForm form;
    form.kind = FormKind::Cone;
    form.point = middle + glm::inverse(sum) * right;
    form.direction = glm::dot(middle - form.point, axis) < 0 ? -axis : axis;
    double most = 0, angles = 0, count = 0;
    const auto along_and_across = [&](const glm::dvec3& p) {
        const glm::dvec3 to = p - form.point;
        const double along = glm::dot(to, form.direction);
        return glm::dvec2(along, glm::length(to - along * form.direction));
    };
    for (const glm::dvec3& p : patch.corners) {
        most = std::max(most, along_and_across(p).y);
    }
    for (const glm::dvec3& p : patch.corners) {
        if (const glm::dvec2 at = along_and_across(p); at.y > kOff * most) {
            angles += std::atan2(at.y, at.x);
            ++count;
        }
    }
    form.half_angle = angles / count;
    for (const glm::dvec3& p : patch.corners) {
        const glm::dvec2 at = along_and_across(p);
        form.deviation =
            std::max(form.deviation, std::abs(at.y * std::cos(form.half_angle) - at.x * std::sin(form.half_angle)));
    }
    return within(form, most);
}

}  // namespace

std::optional<SurfaceForm> fitted_form(const FacetPatch& patch) {
    if (patch.normals.size() < kFewest) {
        return std::nullopt;
    }
    if (const auto axis = axis_of(patch.normals)) {
        constexpr double kAcross = 1e-4;
        return std::abs(glm::dot(*axis, patch.normals[0])) < kAcross ? cylinder(patch.corners, *axis)
                                                                     : cone(patch, *axis);
    }
    return sphere(patch.corners);
}

}  // namespace csg::solid
