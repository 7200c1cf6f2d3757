// Built-in modules that make one mesh or outline of their children.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/tree/finite.h"

namespace csg::scad {

namespace {

using ParameterNames = std::string_view;

void add_mesh(const ModuleContext& c, const MeshOperation& operation, Nodes& out) {
    out.push_back(c.evaluator.builder().mesh(operation, c.children(), c.location(), c.modifiers));
}

/// A number that is finite; warns of anything else that is given.
std::optional<double> finite_number(const ModuleContext& c, const ModuleArguments& arguments,
                                    ParameterNames parameter) {
    const Value& value = arguments[parameter];
    if (value.is_undef()) {
        return std::nullopt;
    }
    if (!value.is_number()) {
        c.warn(fmt::format("{}(..., {}={}) Invalid type: expected number, found {}", c.name(), parameter,
                           value.echo_text(), type_name(value.type())));
        return std::nullopt;
    }
    if (!std::isfinite(value.number())) {
        c.warn(
            fmt::format("{}(..., {}={}) argument cannot be infinite or nan", c.name(), parameter, value.echo_text()));
        return std::nullopt;
    }
    return value.number();
}

std::optional<unsigned> finite_count(const ModuleContext& c, const ModuleArguments& arguments, ParameterNames parameter,
                                     double least) {
    auto number = finite_number(c, arguments, parameter);
    if (!number) {
        return std::nullopt;
    }
    return static_cast<unsigned>(std::clamp(std::trunc(*number), least, 4294967295.0));
}

void read_height(const ModuleContext& c, const ModuleArguments& arguments, LinearExtrude& extrude) {
    const Value& v = arguments["v"];
    bool height_from_v = false;
    if (!v.is_undef()) {
        glm::dvec3 direction(0.0);
        if (to_vec3(v, direction, 0) && std::isfinite(direction.x + direction.y + direction.z) &&
            glm::length(direction) > 0) {
            extrude.has_direction = true;
            extrude.height = glm::length(direction);
            extrude.direction = direction / extrude.height;
            height_from_v = true;
            if (extrude.direction.z < 0) {  // OpenSCAD takes such a vector as one in the plane.
                extrude.direction = glm::dvec3(direction.x, direction.y, 0);
                extrude.height = glm::length(extrude.direction);
                extrude.direction /= extrude.height > 0 ? extrude.height : 1;
            }
        } else {
            c.warn("v when specified should be a 3d vector");
        }
    }
    if (arguments.given("height") && arguments.given("h")) {
        c.warn("Specified both \"height\" and \"h\"");
    }
    const Value& height = arguments[arguments.given("height") ? "height" : "h"];
    if (height.is_number() && std::isfinite(height.number())) {
        extrude.height = std::max(0.0, height.number());
    } else if (!height.is_undef()) {
        c.warn("height when specified should be a number");
    }
    if (extrude.height <= 0 && !height_from_v) {
        extrude.height = 0;
    }
}

void read_scale(const ModuleContext& c, const Value& scale, glm::dvec2& out) {
    glm::dvec2 read(1.0);
    if (scale.is_number()) {
        read = glm::dvec2(scale.number());
    } else if (!to_vec2(scale, read)) {
        read.x = std::nan("");
    }
    if (is_finite(read)) {
        out = glm::max(read, glm::dvec2(0.0));
    } else if (!scale.is_undef()) {
        c.warn(fmt::format("linear_extrude(..., scale={}) could not be converted", scale.echo_text()));
    }
}

void run_linear_extrude(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 7> kParameters{"height", "v",      "scale",   "center",
                                                               "twist",  "slices", "segments"};
    static constexpr std::array<ParameterNames, 2> kNamed{"convexity", "h"};
    const ModuleArguments arguments(c, kParameters, kNamed);
    LinearExtrude extrude;
    extrude.fineness = c.evaluator.fineness(c.where());
    read_height(c, arguments, extrude);
    extrude.convexity = whole(arguments.number("convexity"), 1);
    read_scale(c, arguments["scale"], extrude.scale);
    extrude.center = is_true(arguments["center"]);
    const Value& twist = arguments["twist"];
    if (twist.is_number() && std::isfinite(twist.number()) && twist.number() != 0) {
        extrude.twist = twist.number();
    }
    extrude.slices = finite_count(c, arguments, "slices", 1);
    extrude.segments = finite_count(c, arguments, "segments", 0);
    add_mesh(c, extrude, out);
}

void run_rotate_extrude(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 2> kParameters{"angle", "start"};
    static constexpr std::array<ParameterNames, 2> kNamed{"convexity", "a"};
    const ModuleArguments arguments(c, kParameters, kNamed);
    RotateExtrude extrude;
    extrude.fineness = c.evaluator.fineness(c.where());
    extrude.convexity = whole(arguments.number("convexity"), 2);
    if (arguments.given("angle") && arguments.given("a")) {
        c.warn("Specified both \"angle\" and \"a\"");
    }
    const auto angle = arguments.number(arguments.given("angle") ? "angle" : "a");
    if (angle && std::isfinite(*angle)) {
        extrude.angle = *angle <= -360 || *angle > 360 ? 360 : *angle;
        extrude.start = 0;
    }
    // Without an angle the sweep begins where it always did, opposite to the x axis; so it does for one without end.
    if (const auto start = arguments.number("start"); start && std::isfinite(*start)) {
        extrude.start = *start;
    }
    add_mesh(c, extrude, out);
}

void run_offset(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"r"};
    static constexpr std::array<ParameterNames, 2> kNamed{"delta", "chamfer"};
    const ModuleArguments arguments(c, kParameters, kNamed);
    Offset offset;
    offset.fineness = c.evaluator.fineness(c.where());
    const auto delta = arguments.number("delta");
    if (const auto r = arguments.number("r")) {
        if (delta) {
            c.warn("Ignoring \"delta\" argument as \"r\" is defined too.");
        }
        offset.distance = *r;
    } else if (delta) {
        offset.distance = *delta;
        offset.corner = is_true(arguments["chamfer"]) ? Offset::Corner::Chamfer : Offset::Corner::Miter;
    }
    add_mesh(c, offset, out);
}

void run_fill(const ModuleContext& c, Nodes& out) {
    const ModuleArguments arguments(c, {});
    add_mesh(c, Fill{}, out);
}

void run_hull(const ModuleContext& c, Nodes& out) {
    const ModuleArguments arguments(c, {});
    add_mesh(c, Hull{}, out);
}

/// As it is given, cut off to a whole number: nothing but the .csg text shows it.
int convexity_of(const ModuleArguments& arguments, int otherwise) {
    const double number = arguments.number("convexity").value_or(otherwise);
    constexpr double kMost = std::numeric_limits<int>::max();
    return std::abs(number) <= kMost ? static_cast<int>(number) : std::numeric_limits<int>::min();
}

void run_minkowski(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"convexity"};
    const ModuleArguments arguments(c, kParameters);
    add_mesh(c, Minkowski{convexity_of(arguments, 0)}, out);
}

void run_projection(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"cut"};
    static constexpr std::array<ParameterNames, 1> kNamed{"convexity"};
    const ModuleArguments arguments(c, kParameters, kNamed);
    add_mesh(c, Projection{is_true(arguments["cut"]), convexity_of(arguments, 0)}, out);
}

void run_render(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"convexity"};
    const ModuleArguments arguments(c, kParameters);
    add_mesh(c, Render{convexity_of(arguments, 1)}, out);
}

void run_resize(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 3> kParameters{"newsize", "auto", "convexity"};
    const ModuleArguments arguments(c, kParameters);
    Resize resize;
    const Value& size = arguments["newsize"];
    if (size.is_vector()) {
        const auto given = size.elements();
        for (std::size_t i = 0; i < std::min<std::size_t>(given.size(), 3); ++i) {
            resize.size[static_cast<int>(i)] = given[i].is_number() ? given[i].number() : 0;
        }
    }
    const Value& automatic = arguments["auto"];
    if (automatic.is_vector()) {
        const auto given = automatic.elements();
        for (std::size_t i = 0; i < std::min<std::size_t>(given.size(), 3); ++i) {
            resize.automatic[i] = static_cast<bool>(given[i]);
        }
    } else {
        resize.automatic.fill(is_true(automatic));
    }
    resize.convexity = convexity_of(arguments, 0);
    add_mesh(c, resize, out);
}

void run_roof(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 2> kParameters{"method", "convexity"};
    const ModuleArguments arguments(c, kParameters);
    Roof roof;
    roof.fineness = c.evaluator.fineness(c.where());
    if (const Value& method = arguments["method"]; method.is_string()) {
        if (method.string() == "voronoi" || method.string() == "straight") {
            roof.method = method.string();
        } else {
            c.warn(fmt::format("Unknown roof method '{}'. Using 'voronoi'.", method.string()));
        }
    }
    roof.convexity = whole(arguments.number("convexity"), 1);
    add_mesh(c, roof, out);
}

constexpr std::array kMesh{
    ModuleEntry{"linear_extrude", run_linear_extrude},
    ModuleEntry{"rotate_extrude", run_rotate_extrude},
    ModuleEntry{"offset", run_offset},
    ModuleEntry{"fill", run_fill},
    ModuleEntry{"hull", run_hull},
    ModuleEntry{"minkowski", run_minkowski},
    ModuleEntry{"projection", run_projection},
    ModuleEntry{"render", run_render},
    ModuleEntry{"resize", run_resize},
    ModuleEntry{"roof", run_roof},
};

}  // namespace

std::span<const ModuleEntry> mesh_modules() {
    return kMesh;
}

}  // namespace csg::scad
