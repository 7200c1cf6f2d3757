#include "csg/solid/solid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "csg/solid/mesh_checks.h"
#include "csg/solid/smallest_radius.h"
#include "csg/solid/triangulate.h"
#include "csg/tree/degrees.h"
#include "csg/tree/finite.h"
#include "csg/tree/least_fineness.h"

namespace csg::solid {
namespace {

constexpr int kMostSegments = 1 << 16;

bool usable(double size) {
    return std::isfinite(size) && size > 0;
}

/// All triangles since the last ones that were marked are of that surface.
void mark(Solid& solid, std::uint32_t surface, double bend = 0) {
    FacetGroup group(surface);
    group.bends(bend);
    solid.groups.resize(solid.triangles.size(), group);
}

/// Is a circle of that fineness meant to be a polygon? So it is where $fn asks for a few corners.
bool has_corners(const Fineness& fineness, int segments) {
    return fineness.fn > 0 && 360.0 / segments > kMostBend;
}

/// Appends a ring of `segments` vertices at height z, counter-clockwise seen from above; returns its first index.
std::uint32_t add_ring(Solid& solid, double radius, double z, int segments) {
    const auto first = static_cast<std::uint32_t>(solid.points.size());
    for (int i = 0; i < segments; ++i) {
        const double angle = 360.0 * i / segments;
        solid.points.emplace_back(radius * cos_degrees(angle), radius * sin_degrees(angle), z);
    }
    return first;
}

void add_cap(Solid& solid, std::uint32_t first, int segments, bool up) {
    std::vector<std::uint32_t> face(static_cast<std::size_t>(segments));
    for (std::uint32_t i = 0; i < face.size(); ++i) {
        face[i] = first + i;
    }
    if (!up) {
        std::reverse(face.begin(), face.end());
    }
    triangulate_convex(face, solid.triangles);
}

/// The band between two rings of equally many vertices.
void add_band(Solid& solid, std::uint32_t below, std::uint32_t above, int segments) {
    const auto n = static_cast<std::uint32_t>(segments);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        solid.triangles.emplace_back(below + i, below + j, above + j);
        solid.triangles.emplace_back(below + i, above + j, above + i);
    }
}

void build(const Cube& cube, Solid& solid) {
    if (!usable(cube.size.x) || !usable(cube.size.y) || !usable(cube.size.z)) {
        return;
    }
    const glm::dvec3 lo = cube.center ? cube.size * -0.5 : glm::dvec3(0.0);
    const glm::dvec3 hi = cube.center ? cube.size * 0.5 : cube.size;
    for (unsigned i = 0; i < 8; ++i) {
        solid.points.emplace_back((i & 1) ? hi.x : lo.x, (i & 2) ? hi.y : lo.y, (i & 4) ? hi.z : lo.z);
    }
    constexpr std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& face : faces) {
        triangulate_convex(face, solid.triangles);
        mark(solid, static_cast<std::uint32_t>(solid.triangles.size()));
    }
}

void build(const Sphere& sphere, Solid& solid) {
    if (!usable(sphere.radius)) {
        return;
    }
    const int segments = circle_segments(sphere.radius, sphere.fineness);
    const int rings = (segments + 1) / 2;
    if (std::size_t{2} * static_cast<std::size_t>(segments) * static_cast<std::size_t>(rings) > kMostTriangles) {
        solid.failures.emplace_back("sphere has more than 16777216 triangles; it is left out");
        return;
    }
    std::uint32_t last = 0;
    for (int i = 0; i < rings; ++i) {
        // From the south pole up.
        const double phi = 180.0 * (rings - 1 - i + 0.5) / rings;
        const std::uint32_t ring =
            add_ring(solid, sphere.radius * sin_degrees(phi), sphere.radius * cos_degrees(phi), segments);
        if (i == 0) {
            add_cap(solid, ring, segments, false);
        } else {
            add_band(solid, last, ring, segments);
        }
        last = ring;
    }
    add_cap(solid, last, segments, true);
    mark(solid, 0, std::max(360.0 / segments, 180.0 / rings));
}

/// The mantle of a cylinder between its caps, or that of a cone.
void mark_mantle(Solid& solid, const Cylinder& cylinder, int segments, std::size_t triangles_of_facet) {
    if (!has_corners(cylinder.fineness, segments)) {
        const double upright = cylinder.height / std::hypot(cylinder.height, cylinder.radius2 - cylinder.radius1);
        return mark(solid, 1, 360.0 / segments * upright);
    }
    for (std::uint32_t facet = 1; solid.groups.size() < solid.triangles.size(); ++facet) {
        solid.groups.resize(solid.groups.size() + triangles_of_facet, FacetGroup(facet));
    }
}

void build(const Cylinder& cylinder, Solid& solid) {
    const double r1 = cylinder.radius1, r2 = cylinder.radius2, h = cylinder.height;
    if (!usable(h) || !std::isfinite(r1) || !std::isfinite(r2) || r1 < 0 || r2 < 0 || (r1 == 0 && r2 == 0)) {
        return;
    }
    const int segments = circle_segments(std::max(r1, r2), cylinder.fineness);
    const auto n = static_cast<std::uint32_t>(segments);
    const double z1 = cylinder.center ? -h / 2 : 0, z2 = cylinder.center ? h / 2 : h;
    if (r1 > 0 && r2 > 0) {
        const std::uint32_t below = add_ring(solid, r1, z1, segments), above = add_ring(solid, r2, z2, segments);
        add_cap(solid, below, segments, false);
        mark(solid, 0);
        add_band(solid, below, above, segments);
        mark_mantle(solid, cylinder, segments, 2);
        add_cap(solid, above, segments, true);
        mark(solid, n + 1);
        return;
    }
    const bool up = r2 == 0;
    const std::uint32_t ring = add_ring(solid, up ? r1 : r2, up ? z1 : z2, segments);
    solid.points.emplace_back(0.0, 0.0, up ? z2 : z1);
    add_cap(solid, ring, segments, !up);
    mark(solid, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = ring + i, b = ring + (i + 1) % n;
        if (up) {
            solid.triangles.emplace_back(a, b, ring + n);
        } else {
            solid.triangles.emplace_back(b, a, ring + n);
        }
    }
    mark_mantle(solid, cylinder, segments, 1);
}

/// Fills points and triangles; `first` tells which points are one. False where a face has an index out of bounds.
bool add_faces(const Polyhedron& polyhedron, std::span<const std::uint32_t> first, Solid& solid) {
    solid.points = polyhedron.points;
    solid.triangles.clear();
    std::vector<std::uint32_t> face;
    bool good = true;
    for (const auto& loop : polyhedron.faces) {
        face.clear();
        std::copy_if(loop.rbegin(), loop.rend(), std::back_inserter(face),
                     [&](std::uint32_t index) { return index < polyhedron.points.size(); });
        good = good && face.size() == loop.size();
        weld(face, first);
        triangulate(polyhedron.points, face, solid.triangles);
    }
    return good;
}

void build(const std::shared_ptr<const Polyhedron>& polyhedron, Solid& solid) {
    if (!polyhedron) {
        return;
    }
    const std::vector<glm::dvec3>& points = polyhedron->points;
    for (const glm::dvec3& p : points) {
        if (!is_finite(p)) {
            solid.failures.emplace_back("polyhedron has a point that is not finite; it is left out");
            return;
        }
    }
    std::size_t triangles = 0;
    for (const auto& loop : polyhedron->faces) {
        triangles += loop.size() < 3 ? 0 : loop.size() - 2;
    }
    if (triangles > kMostTriangles) {
        solid.failures.emplace_back("polyhedron has more than 16777216 triangles; it is left out");
        return;
    }
    // Faces that meet in equal points meet: indices of the first of equals stand for all.
    if (!add_faces(*polyhedron, first_of_equals(points), solid)) {
        solid.failures.emplace_back("polyhedron has a face with a point index that is out of bounds; it is ignored");
    }
}

/// Where a polyhedron is open, gaps that no picture shows are closed, if that is all that was missing.
void close_gaps(const Polyhedron& polyhedron, Solid& solid) {
    constexpr double kGap = 1e-11;  // Of the diagonal.
    Solid closed;
    (void)add_faces(polyhedron, first_of_near(polyhedron.points, kGap * solid.box.diagonal()), closed);
    closed.box = solid.box;
    if (closed.triangles.empty()) {
        return;
    }
    check_mesh(closed);
    if (closed.closed) {
        closed.warnings = std::move(solid.warnings);
        closed.failures = std::move(solid.failures);
        solid = std::move(closed);
    }
}

/// Outlines and what comes from files are made elsewhere (node_geometry.h).
template <typename Shape>
void build(const Shape&, Solid&) {}

/// So many that no edge is further from the circle than `error`; not fewer than five, and not more than the least $fa
/// and $fs give.
int segments_by_error(double r, double error) {
    const double least = 5;
    const double most = std::max(std::min(360 / kLeastFineness, r * 2 * std::numbers::pi / kLeastFineness), least);
    const double cosine = 1 - error / r;
    if (cosine <= std::cos(std::numbers::pi / least)) {
        return static_cast<int>(least);
    }
    return static_cast<int>(std::ceil(std::min(std::numbers::pi / std::acos(cosine), most)));
}

}  // namespace

int circle_segments(double r, const Fineness& fineness) {
    if (!(r >= kSmallestRadius) || !std::isfinite(fineness.fn) || !std::isfinite(r)) {
        return 3;
    }
    if (fineness.fn > 0) {
        return static_cast<int>(std::clamp(fineness.fn, 3.0, double{kMostSegments}));
    }
    if (fineness.fe && *fineness.fe >= kSmallestRadius) {
        return segments_by_error(r, *fineness.fe);
    }
    // As OpenSCAD, which ignores what is no number.
    const double wanted =
        std::ceil(std::fmax(std::fmin(360.0 / fineness.fa, r * 2.0 * std::numbers::pi / fineness.fs), 5.0));
    return static_cast<int>(std::min(wanted, double{kMostSegments}));
}

std::string too_fine(const Fineness& fineness) {
    return fineness.fn > kMostSegments && std::isfinite(fineness.fn)
               ? fmt::format("it needs {:.15g} segments, and {} are the most", fineness.fn, kMostSegments)
               : std::string();
}

std::shared_ptr<const Solid> make_solid(const LeafShape& shape) {
    auto solid = std::make_shared<Solid>();
    std::visit(
        [&](const auto& s) {
            if constexpr (requires { s.fineness; }) {
                if (const std::string problem = too_fine(s.fineness); !problem.empty()) {
                    solid->failures.push_back("this object is left out: " + problem);
                    return;
                }
            }
            build(s, *solid);
        },
        shape);
    for (const glm::dvec3& p : solid->points) {
        solid->box = enclose(solid->box, p);
    }
    if (!std::holds_alternative<std::shared_ptr<const Polyhedron>>(shape)) {
        solid->closed = !solid->triangles.empty();
        solid->convex = solid->simple = solid->closed;
        return solid;
    }
    if (!solid->triangles.empty()) {
        check_mesh(*solid);
        if (!solid->closed) {
            close_gaps(*std::get<std::shared_ptr<const Polyhedron>>(shape), *solid);
        }
        if (!solid->closed) {
            solid->warnings.emplace_back("polyhedron is not closed, or its faces are not all oriented alike");
        }
        estimate_groups(*solid);
    }
    return solid;
}

}  // namespace csg::solid
