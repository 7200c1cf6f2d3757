// Built-in modules that make leaves.
#include <algorithm>
#include <array>
#include <cmath>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/tree/finite.h"

namespace csg::scad {

namespace {

using ParameterNames = std::string_view;

void check_ranges(const ModuleContext& c, const Cylinder& cylinder) {
    if (!is_positive(cylinder.height)) {
        c.warn(fmt::format("cylinder(h={}, ...)", number_text(cylinder.height)));
    }
    const double r1 = cylinder.radius1, r2 = cylinder.radius2;
    const bool cone = (is_positive(r1) && r2 == 0) || (r1 == 0 && is_positive(r2));
    if (!cone && !(is_positive(r1) && is_positive(r2))) {
        c.warn(fmt::format("cylinder(r1={}, r2={}, ...)", number_text(r1), number_text(r2)));
    }
}

void run_cube(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 2> kParameters{"size", "center"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters);
    Cube cube;
    const Value& size = arguments["size"];
    if (size.is_number()) {
        cube.size = glm::dvec3(size.number());
    } else if (!size.is_undef() && !to_vec3(size, cube.size, std::nan(""))) {
        c.warn(fmt::format("Unable to convert cube(size={}, ...) parameter to a number or a vec3 of numbers",
                           size.echo_text()));
    }
    const bool makes_nothing = !is_positive(cube.size.x) || !is_positive(cube.size.y) || !is_positive(cube.size.z);
    if (makes_nothing && c.evaluator.request().check_ranges) {
        c.warn(fmt::format("cube(size={}, ...)", size.echo_text()));
    }
    cube.center = is_true(arguments["center"]);
    add_leaf(c, cube, out);
}

void run_sphere(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"r"};
    static constexpr std::array<ParameterNames, 1> kNamed{"d"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    Sphere sphere;
    sphere.fineness = c.evaluator.fineness(c.where());
    sphere.radius = radius(c, arguments, "r", "d").value_or(1);
    if (!is_positive(sphere.radius) && c.evaluator.request().check_ranges) {
        c.warn(fmt::format("sphere(r={})", number_text(sphere.radius)));
    }
    add_leaf(c, sphere, out);
}

void run_cylinder(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 4> kParameters{"h", "r1", "r2", "center"};
    static constexpr std::array<ParameterNames, 4> kNamed{"r", "d", "d1", "d2"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    Cylinder cylinder;
    cylinder.fineness = c.evaluator.fineness(c.where());
    cylinder.height = arguments.number("h").value_or(1);
    const auto both = radius(c, arguments, "r", "d");
    const auto below = radius(c, arguments, "r1", "d1");
    const auto above = radius(c, arguments, "r2", "d2");
    if (both && (below || above)) {
        c.warn("Cylinder parameters ambiguous");
    }
    cylinder.radius1 = below.value_or(both.value_or(1));
    cylinder.radius2 = above.value_or(both.value_or(1));
    if (c.evaluator.request().check_ranges) {
        check_ranges(c, cylinder);
    }
    cylinder.center = is_true(arguments["center"]);
    add_leaf(c, cylinder, out);
}

std::vector<glm::dvec3> solid_points_of(const ModuleContext& c, const Value& value) {
    if (!value.is_vector()) {
        c.warn(fmt::format("Unable to convert points = {} to a vector of coordinates", value.echo_text()));
        return {};
    }
    std::vector<glm::dvec3> points;
    points.reserve(value.elements().size());
    for (const Value& element : value.elements()) {
        glm::dvec3 point(0.0);
        if (!to_vec3(element, point, 0) || !is_finite(point)) {
            c.warn(fmt::format("Unable to convert points[{}] = {} to a vec3 of numbers", points.size(),
                               element.echo_text()));
            point = glm::dvec3(0.0);
        }
        points.push_back(point);
    }
    return points;
}

/// Indices that are no points of `count` are left out, with a warning.
std::vector<std::uint32_t> face_of(const ModuleContext& c, std::size_t face, std::span<const Value> indices,
                                   std::size_t count) {
    std::vector<std::uint32_t> loop;
    loop.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const Value& index = indices[i];
        if (!index.is_number()) {
            c.warn(fmt::format("Unable to convert faces[{}][{}] = {} to a number", face, i, index.echo_text()));
        } else if (const double whole = std::trunc(index.number()); whole >= 0 && whole < static_cast<double>(count)) {
            loop.push_back(static_cast<std::uint32_t>(whole));
        } else {
            c.warn(fmt::format("Point index {} is out of bounds (from faces[{}][{}])", number_text(whole), face, i));
        }
    }
    return loop;
}

void run_polyhedron(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 3> kParameters{"points", "faces", "convexity"};
    static constexpr std::array<ParameterNames, 1> kNamed{"triangles"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    auto polyhedron = std::make_shared<Polyhedron>();
    const bool has_points = arguments["points"].is_vector();
    polyhedron->points = solid_points_of(c, arguments["points"]);
    const bool old = arguments["faces"].is_undef() && !arguments["triangles"].is_undef();
    if (old) {
        c.evaluator.emit(
            Severity::Deprecated, c.where(),
            "polyhedron(triangles=[]) will be removed in future releases. Use polyhedron(faces=[]) instead.");
    }
    const Value& faces = arguments[old ? "triangles" : "faces"];
    if (faces.is_vector() && has_points) {
        const auto given = faces.elements();
        polyhedron->faces.reserve(given.size());
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (!given[i].is_vector()) {
                c.warn(fmt::format("Unable to convert faces[{}] = {} to a vector of numbers", i, given[i].echo_text()));
                continue;
            }
            auto loop = face_of(c, i, given[i].elements(), polyhedron->points.size());
            if (loop.size() >= 3) {
                polyhedron->faces.push_back(std::move(loop));
            }
        }
    } else if (has_points) {
        c.warn(fmt::format("Unable to convert faces = {} to a vector of vector of point indices", faces.echo_text()));
    }
    polyhedron->convexity = whole(arguments.number("convexity"), 1);
    add_leaf(c, std::shared_ptr<const Polyhedron>(std::move(polyhedron)), out);
}

constexpr std::array kShapes{
    ModuleEntry{"cube", run_cube},
    ModuleEntry{"sphere", run_sphere},
    ModuleEntry{"cylinder", run_cylinder},
    ModuleEntry{"polyhedron", run_polyhedron},
};

}  // namespace

std::span<const ModuleEntry> shape_modules() {
    return kShapes;
}

}  // namespace csg::scad
