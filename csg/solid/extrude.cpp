#include "csg/solid/extrude.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/solid/mesh_checks.h"
#include "csg/solid/outline_curves.h"
#include "csg/solid/segments.h"
#include "csg/solid/slices.h"
#include "csg/solid/triangulate_region.h"
#include "csg/solid/wall_bends.h"
#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

/// The outline turned clockwise by `degrees`, then scaled.
void add_ring(Solid& solid, std::span<const glm::dvec2> points, const glm::dvec3& offset, double degrees,
              const glm::dvec2& scale) {
    const double c = cos_degrees(-degrees), s = sin_degrees(-degrees);
    for (const glm::dvec2& p : points) {
        const glm::dvec2 turned = degrees == 0 ? p : glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y);
        solid.points.push_back(offset + glm::dvec3(turned * scale, 0.0));
    }
}

/// The quadrilateral a, b (below), c, d (above), split along its shorter diagonal; where they are equal, along the one
/// that the twist asks for; the other way around where the top is flattened (`flat_top`), which would give folds
/// without thickness: all as in OpenSCAD.
void add_quad(Solid& solid, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, bool turns_right,
              bool flat_top) {
    constexpr double kEqual = 1e-5;
    const double ac = glm::length(solid.points[c] - solid.points[a]);
    const double bd = glm::length(solid.points[d] - solid.points[b]);
    const bool equal = 2 * std::abs(ac - bd) <= kEqual * (ac + bd);
    if ((equal ? turns_right : ac < bd) != flat_top) {
        solid.triangles.emplace_back(a, b, c);
        solid.triangles.emplace_back(a, c, d);
    } else {
        solid.triangles.emplace_back(a, b, d);
        solid.triangles.emplace_back(b, c, d);
    }
}

}  // namespace

void finish(Solid& solid) {
    solid.box = {};
    for (const glm::dvec3& p : solid.points) {
        solid.box = enclose(solid.box, p);
    }
    if (!solid.triangles.empty()) {
        check_mesh(solid);
        if (solid.groups.size() != solid.triangles.size()) {
            estimate_groups(solid);
        }
    }
}

std::shared_ptr<Solid> linear_extrude(const Outline& given, const LinearExtrude& how) {
    auto solid = std::make_shared<Solid>();
    if (given.empty() || !(how.height > 0) || !std::isfinite(how.height)) {
        return solid;
    }
    const std::size_t slices = slice_count(given, how);
    // Loops that meet in a point share it.
    const Outline divided = divide_edges(given, how, slices);
    const IndexedOutline outline = index_corners(divided);
    const std::size_t corners = outline.points.size();
    const std::size_t most = std::min(kMostTriangles / corners / 2, static_cast<std::size_t>(kMostSlices) - 1);
    if (slices > most) {
        throw GeometryError(
            fmt::format("linear_extrude() has too many slices: {} of {} corners each", slices, corners));
    }
    const glm::dvec3 way = how.direction * how.height;
    const glm::dvec3 begin = how.center ? way * -0.5 : glm::dvec3(0.0);
    for (std::size_t i = 0; i <= slices; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(slices);
        const glm::dvec3 end = how.center ? way * 0.5 : way;
        add_ring(*solid, outline.points, i == slices ? end : begin + way * t, how.twist.value_or(0) * t,
                 glm::dvec2(1.0) + (how.scale - glm::dvec2(1.0)) * t);
    }
    const OutlineCurves curves = curves_of(given, divided);
    const auto n = static_cast<std::uint32_t>(corners);
    const auto top = static_cast<std::uint32_t>(slices * corners);
    for (const glm::uvec3& t : triangulate_region(outline)) {
        solid->triangles.emplace_back(t.x, t.z, t.y);
        solid->triangles.push_back(t + top);
        solid->groups.emplace_back(curves.count);
        solid->groups.emplace_back(curves.count + 1);
    }
    const std::size_t walls = solid->triangles.size();
    for (std::uint32_t i = 0; i < slices; ++i) {
        const std::uint32_t first = i * n;
        const bool flat_top = i + 1 == slices && (how.scale.x == 0 || how.scale.y == 0);
        for (std::size_t l = 0; l < outline.loops.size(); ++l) {
            const auto& loop = outline.loops[l];
            const bool right = (how.twist.value_or(0) > 0) == (area2(divided.loops[l]) > 0);
            for (std::size_t j = 0; j < loop.size(); ++j) {
                const std::uint32_t a = first + loop[j], b = first + loop[(j + 1) % loop.size()];
                add_quad(*solid, a, b, b + n, a + n, right, flat_top);
            }
        }
    }
    group_walls(*solid, walls, curves, slices);
    finish(*solid);
    // Where it turns or is not scaled alike, walls are bent, and those of thin places may pass through each other.
    solid->simple = how.twist.value_or(0) == 0 && how.scale.x == how.scale.y && how.scale.x >= 0;
    return solid;
}

std::shared_ptr<Solid> slab(const Outline& outline) {
    LinearExtrude how;
    how.height = 1;
    how.center = true;
    auto solid = linear_extrude(outline, how);
    solid->flat = true;
    return solid;
}

}  // namespace csg::solid
