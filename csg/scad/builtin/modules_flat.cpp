// Built-in modules that make outlines in the plane.
#include <algorithm>
#include <array>
#include <cmath>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/scad/builtin/text_parameters.h"
#include "csg/tree/finite.h"

namespace csg::scad {

namespace {

using ParameterNames = std::string_view;

void run_square(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 2> kParameters{"size", "center"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters);
    Square square;
    const Value& size = arguments["size"];
    if (size.is_number()) {
        square.size = glm::dvec2(size.number());
    } else if (!size.is_undef() && !to_vec2(size, square.size)) {
        c.warn(fmt::format("Unable to convert square(size={}, ...) parameter to a number or a vec2 of numbers",
                           size.echo_text()));
    }
    if ((!is_positive(square.size.x) || !is_positive(square.size.y)) && c.evaluator.request().check_ranges) {
        c.warn(fmt::format("square(size={}, ...)", size.echo_text()));
    }
    square.center = is_true(arguments["center"]);
    add_leaf(c, square, out);
}

void run_circle(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"r"};
    static constexpr std::array<ParameterNames, 1> kNamed{"d"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    Circle circle;
    circle.fineness = c.evaluator.fineness(c.where());
    circle.radius = radius(c, arguments, "r", "d").value_or(1);
    if (!is_positive(circle.radius) && c.evaluator.request().check_ranges) {
        c.warn(fmt::format("circle(r={})", number_text(circle.radius)));
    }
    add_leaf(c, circle, out);
}

std::vector<glm::dvec2> flat_points_of(const ModuleContext& c, const Value& value) {
    if (!value.is_vector()) {
        c.warn(fmt::format("Unable to convert points = {} to a vector of coordinates", value.echo_text()));
        return {};
    }
    std::vector<glm::dvec2> points;
    points.reserve(value.elements().size());
    for (const Value& element : value.elements()) {
        glm::dvec2 point(0.0);
        if (!to_vec2(element, point) || !is_finite(point)) {
            c.warn(fmt::format("Unable to convert points[{}] = {} to a vec2 of numbers", points.size(),
                               element.echo_text()));
            point = glm::dvec2(0.0);
        }
        points.push_back(point);
    }
    return points;
}

std::vector<std::uint32_t> path_of(const ModuleContext& c, std::size_t path, const Value& value, std::size_t count) {
    std::vector<std::uint32_t> indices;
    const auto elements = value.elements();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (!elements[i].is_number()) {
            c.warn(fmt::format("Unable to convert paths[{}][{}] = {} to a number", path, i, elements[i].echo_text()));
        } else if (const double whole = std::trunc(elements[i].number());
                   whole >= 0 && whole < static_cast<double>(count)) {
            indices.push_back(static_cast<std::uint32_t>(whole));
        } else {
            c.warn(fmt::format("Point index {} is out of bounds (from paths[{}][{}])", number_text(whole), path, i));
        }
    }
    return indices;
}

void run_polygon(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 3> kParameters{"points", "paths", "convexity"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters);
    auto polygon = std::make_shared<Polygon>();
    polygon->points = flat_points_of(c, arguments["points"]);
    const Value& paths = arguments["paths"];
    if (paths.is_vector()) {
        const auto given = paths.elements();
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (given[i].is_vector()) {
                polygon->paths.push_back(path_of(c, i, given[i], polygon->points.size()));
            } else {
                c.warn(fmt::format("Unable to convert paths[{}] = {} to a vector of numbers", i, given[i].echo_text()));
            }
        }
        polygon->has_paths = !polygon->paths.empty();
    } else if (!paths.is_undef()) {
        c.warn(fmt::format("Unable to convert paths = {} to a vector of vector of point indices", paths.echo_text()));
    }
    polygon->convexity = whole(arguments.number("convexity"), 1);
    add_leaf(c, std::shared_ptr<const Polygon>(std::move(polygon)), out);
}

/// The parameter's text; a value that is none gives a warning and what was there before.
void run_text(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 3> kParameters{"text", "size", "font"};
    static constexpr std::array<ParameterNames, 7> kNamed{"direction", "language", "script", "halign",
                                                          "valign",    "spacing",  "em"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    const Fineness fineness = c.evaluator.fineness(c.where());
    auto text = std::make_shared<Text>(read_text_parameters(
        c.name(), [&](ParameterNames parameter) -> const Value& { return arguments[parameter]; },
        [&](std::string warning) { c.warn(std::move(warning)); }));
    text->fineness = fineness;
    text->font_files = c.evaluator.program().fonts();
    add_leaf(c, std::shared_ptr<const Text>(std::move(text)), out);
}

constexpr std::array kFlat{
    ModuleEntry{"square", run_square},
    ModuleEntry{"circle", run_circle},
    ModuleEntry{"polygon", run_polygon},
    ModuleEntry{"text", run_text},
};

}  // namespace

std::span<const ModuleEntry> flat_modules() {
    return kFlat;
}

}  // namespace csg::scad
