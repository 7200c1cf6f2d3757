// Built-in modules that combine, move and color their children.
#include <algorithm>
#include <array>
#include <cmath>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/scad/builtin/color_names.h"
#include "csg/scad/builtin/sine.h"
#include "csg/tree/finite.h"

namespace csg::scad {

namespace {

using ParameterNames = std::string_view;
using Axes = std::array<glm::dvec3, 3>;  ///< Columns of a linear map.

template <Operation kOperation>
void run_combination(const ModuleContext& c, Nodes& out) {
    const ModuleArguments arguments(c, {});
    out.push_back(c.evaluator.builder().combine(kOperation, c.children(), c.location(), c.modifiers));
}

void add_transform(const ModuleContext& c, const Axes& axes, const glm::dvec3& offset, Nodes& out) {
    glm::dmat4 matrix(1.0);
    for (int column = 0; column < 3; ++column) {
        matrix[column] = glm::dvec4(axes[static_cast<std::size_t>(column)], 0.0);
    }
    matrix[3] = glm::dvec4(offset, 1.0);
    out.push_back(c.evaluator.builder().transform(matrix, c.children(), c.location(), c.modifiers));
}

constexpr Axes identity() {
    return {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
}

void run_translate(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"v"};
    const ModuleArguments arguments(c, kParameters);
    glm::dvec3 offset(0.0);
    if (!to_vec3(arguments["v"], offset, 0) || !is_finite(offset)) {
        c.warn(fmt::format("Unable to convert translate({}) parameter to a vec3 or vec2 of numbers",
                           arguments["v"].echo_text()));
        offset = glm::dvec3(0.0);
    }
    add_transform(c, identity(), offset + 0.0, out);
}

void run_scale(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"v"};
    const ModuleArguments arguments(c, kParameters);
    const Value& v = arguments["v"];
    glm::dvec3 factor(1.0);
    if (v.is_number()) {
        factor = glm::dvec3(v.number());
    } else if (!to_vec3(v, factor, 1)) {
        c.warn(fmt::format("Unable to convert scale({}) parameter to a number, a vec3 or vec2 of numbers or a number",
                           v.echo_text()));
    }
    const bool flat = factor.x * factor.y * factor.z == 0 || !is_finite(factor);
    if (flat && c.evaluator.request().check_ranges) {
        c.warn(fmt::format("scale({})", v.echo_text()));
    }
    Axes axes = identity();
    axes[0] *= factor.x;
    axes[1] *= factor.y;
    axes[2] *= factor.z;
    add_transform(c, axes, glm::dvec3(0.0), out);
}

void run_mirror(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"v"};
    const ModuleArguments arguments(c, kParameters);
    glm::dvec3 n(1, 0, 0);
    if (!to_vec3(arguments["v"], n, 0)) {
        c.warn(fmt::format("Unable to convert mirror({}) parameter to a vec3 or vec2 of numbers",
                           arguments["v"].echo_text()));
    }
    Axes axes = identity();
    // I - 2 n nᵀ. Divided by the square of the length, so that whole numbers stay exact.
    const double square = n.x * n.x + n.y * n.y + n.z * n.z;
    if (n != glm::dvec3(0.0)) {
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t row = 0; row < 3; ++row) {
                const auto i = static_cast<int>(row), j = static_cast<int>(column);
                const double product = -2 * n[i] * n[j] / square;
                axes[column][i] = row == column ? 1 + product : product;
            }
        }
    }
    add_transform(c, axes, glm::dvec3(0.0), out);
}

/// A zero loses its sign unless all of its column has one: what is left when OpenSCAD multiplies the identity by such a
/// matrix, and shows in .csg texts.
Axes with_settled_zeros(Axes axes) {
    for (glm::dvec3& column : axes) {
        const bool all_signed = std::signbit(column.x) && std::signbit(column.y) && std::signbit(column.z);
        if (!all_signed) {
            column += 0.0;
        }
    }
    return axes;
}

/// By `degrees` about an axis of any length but 0 (Rodrigues). Products come before the division, so that axes of whole
/// numbers give exact results where there are any.
Axes about(const glm::dvec3& axis, double degrees) {
    const double square = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
    const double c = cosine(degrees);
    const glm::dvec3 s = sine(degrees) * axis / std::sqrt(square);
    const auto part = [&](double a, double b) { return (1 - c) * a * b / square; };
    const auto [x, y, z] = std::array{axis.x, axis.y, axis.z};
    return with_settled_zeros({glm::dvec3(part(x, x) + c, part(x, y) + s.z, part(x, z) - s.y),
                               glm::dvec3(part(x, y) - s.z, part(y, y) + c, part(y, z) + s.x),
                               glm::dvec3(part(x, z) + s.y, part(y, z) - s.x, part(z, z) + c)});
}

/// Angles about x, then y, then z. False where something is no finite number, or there are more than three. Numbers
/// that are not finite give a matrix that is not, which leaves the object out, and what is no number is taken to be the
/// angle after it, both as in OpenSCAD.
bool rotate_about_axes(std::span<const Value> angles, Axes& axes) {
    bool good = angles.size() <= 3;
    std::array<double, 3> degrees{};
    double last = 0;
    for (std::size_t i = std::min<std::size_t>(angles.size(), 3); i-- > 0;) {
        last = angles[i].is_number() ? angles[i].number() : last;
        good = good && angles[i].is_number() && std::isfinite(last);
        degrees[i] = last;
    }
    const auto [sx, sy, sz] = std::array{sine(degrees[0]), sine(degrees[1]), sine(degrees[2])};
    const auto [cx, cy, cz] = std::array{cosine(degrees[0]), cosine(degrees[1]), cosine(degrees[2])};
    axes = with_settled_zeros({glm::dvec3(cy * cz, cy * sz, -sy),
                               glm::dvec3(cz * sx * sy - cx * sz, cx * cz + sx * sy * sz, cy * sx),
                               glm::dvec3(cx * cz * sy + sx * sz, -cz * sx + cx * sy * sz, cx * cy)});
    return good;
}

void run_rotate(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 2> kParameters{"a", "v"};
    const ModuleArguments arguments(c, kParameters);
    const Value &a = arguments["a"], &v = arguments["v"];
    Axes axes = identity();
    if (a.is_vector()) {
        if (!rotate_about_axes(a.elements(), axes)) {
            c.warn(v.is_undef()
                       ? fmt::format("Problem converting rotate(a={}) parameter", a.echo_text())
                       : fmt::format("Problem converting rotate(a={}, v={}) parameter", a.echo_text(), v.echo_text()));
        } else if (!v.is_undef()) {
            c.warn(fmt::format("When parameter a is supplied as vector, v is ignored rotate(a={}, v={})", a.echo_text(),
                               v.echo_text()));
        }
        add_transform(c, axes, glm::dvec3(0.0), out);
        return;
    }
    const bool angle = a.is_number() && std::isfinite(a.number());
    glm::dvec3 axis(0, 0, 1);
    const bool axis_good = v.is_undef() || to_vec3(v, axis, 0);
    if (!axis_good) {
        c.warn(angle ? fmt::format("Problem converting rotate(..., v={}) parameter", v.echo_text())
                     : fmt::format("Problem converting rotate(a={}, v={}) parameter", a.echo_text(), v.echo_text()));
    } else if (!angle) {
        c.warn(fmt::format("Problem converting rotate(a={}) parameter", a.echo_text()));
    }
    if (angle) {
        if (!axis_good) {
            axis = glm::dvec3(0, 0, 1);
        }
        const double square = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
        if (square > 0 && std::isfinite(square)) {
            axes = about(axis, a.number());
        }
    }
    add_transform(c, axes, glm::dvec3(0.0), out);
}

void run_multmatrix(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 1> kParameters{"m"};
    const ModuleArguments arguments(c, kParameters);
    glm::dmat4 matrix(1.0);
    const Value& m = arguments["m"];
    if (m.is_vector()) {
        const auto rows = m.elements();
        for (std::size_t row = 0; row < std::min<std::size_t>(rows.size(), 4); ++row) {
            const auto cells = rows[row].is_vector() ? rows[row].elements() : std::span<const Value>();
            for (std::size_t column = 0; column < std::min<std::size_t>(cells.size(), 4); ++column) {
                if (cells[column].is_number()) {
                    matrix[static_cast<int>(column)][static_cast<int>(row)] = cells[column].number();
                }
            }
        }
        const double w = matrix[3][3];
        if (w != 1.0) {
            matrix /= w;
            matrix[3][3] = w == 0.0 ? matrix[3][3] : 1.0;
        }
    }
    out.push_back(c.evaluator.builder().transform(matrix, c.children(), c.location(), c.modifiers));
}

/// From a list of three or four numbers. Components that are not given stay as they are.
void read_components(const ModuleContext& c, std::span<const Value> components, Rgba& color) {
    std::array<float*, 4> parts{&color.r, &color.g, &color.b, &color.a};
    color = {1, 1, 1, 1};
    for (std::size_t i = 0; i < std::min<std::size_t>(components.size(), 4); ++i) {
        const double part = components[i].is_number() ? components[i].number() : 0;
        *parts[i] = static_cast<float>(part);
        if (part < 0 || part > 1) {
            c.warn(fmt::format("color() expects numbers between 0.0 and 1.0. Value of {:.1f} is out of range", part));
        }
    }
}

void run_color(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 2> kParameters{"c", "alpha"};
    const ModuleArguments arguments(c, kParameters);
    Rgba color{-1, -1, -1, -1};
    const Value& given = arguments["c"];
    if (given.is_vector()) {
        read_components(c, given.elements(), color);
    } else if (given.is_string()) {
        if (const auto found = find_color(given.string())) {
            color = *found;
        } else {
            c.warn(fmt::format("Unable to parse color \"{}\"", given.string()));
        }
    }
    if (const auto alpha = arguments.number("alpha")) {
        color.a = static_cast<float>(*alpha);
        if (*alpha < 0 || *alpha > 1) {
            c.warn(fmt::format("color() expects alpha between 0.0 and 1.0. Value of {:.1f} is out of range", *alpha));
        }
    }
    out.push_back(c.evaluator.builder().color(color, c.children(), c.location(), c.modifiers));
}

constexpr std::array kTransforms{
    ModuleEntry{"union", run_combination<Operation::Union>},
    ModuleEntry{"difference", run_combination<Operation::Difference>},
    ModuleEntry{"intersection", run_combination<Operation::Intersection>},
    ModuleEntry{"translate", run_translate},
    ModuleEntry{"rotate", run_rotate},
    ModuleEntry{"scale", run_scale},
    ModuleEntry{"mirror", run_mirror},
    ModuleEntry{"multmatrix", run_multmatrix},
    ModuleEntry{"color", run_color},
};

}  // namespace

std::span<const ModuleEntry> transform_modules() {
    return kTransforms;
}

}  // namespace csg::scad
