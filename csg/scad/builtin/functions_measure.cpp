// Built-in functions that ask fonts and drawings.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "csg/scad/builtin/builtin_functions.h"
#include "csg/scad/builtin/measures.h"
#include "csg/scad/builtin/named_arguments.h"
#include "csg/scad/builtin/text_parameters.h"
#include "csg/scad/value/object.h"

namespace csg::scad {

namespace {

using ParameterNames = std::string_view;

Value vector_of(const glm::dvec2& v) {
    std::array<Value, 2> elements{v.x, v.y};
    return Value::list(elements);
}

/// What `ask` gets out of the measures, with its warnings.
template <typename Ask>
auto answer(FunctionHost& host, std::string_view name, Ask&& ask)
    -> decltype(ask(*host.measures, std::declval<MeasureWarnings&>())) {
    if (host.measures == nullptr) {
        host.warn(fmt::format("{}() is not available here", name));
        return std::nullopt;
    }
    MeasureWarnings warnings;
    auto result = ask(*host.measures, warnings);
    for (std::string& warning : warnings.of_file) {
        host.warn_without_place(std::move(warning));
    }
    for (std::string& warning : warnings.at_call) {
        host.warn(std::move(warning));
    }
    return result;
}

Text text_of(std::string_view name, const NamedArguments& arguments, FunctionHost& host) {
    Text text = read_text_parameters(
        name, [&](ParameterNames parameter) -> const Value& { return arguments[parameter]; }, host.warn);
    text.font_files = host.font_files;
    return text;
}

Value textmetrics(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    static constexpr std::array<ParameterNames, 10> kParameters{"text",   "size",   "font",   "direction", "language",
                                                                "script", "halign", "valign", "spacing",   "em"};
    const Text text = text_of(name, NamedArguments(a, kParameters, host), host);
    const auto metrics = answer(host, name, [&](Measures& m, auto& warnings) { return m.text(text, warnings); });
    if (!metrics) {
        return {};
    }
    ObjectEntries result;
    result.set("position", vector_of(metrics->position));
    result.set("size", vector_of(metrics->size));
    result.set("ascent", metrics->ascent);
    result.set("descent", metrics->descent);
    result.set("offset", vector_of(metrics->offset));
    result.set("advance", vector_of(metrics->advance));
    return Value(std::move(result));
}

Value fontmetrics(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    static constexpr std::array<ParameterNames, 3> kParameters{"size", "font", "em"};
    const Text text = text_of(name, NamedArguments(a, kParameters, host), host);
    const auto metrics = answer(host, name, [&](Measures& m, auto& warnings) { return m.font(text, warnings); });
    if (!metrics) {
        return {};
    }
    const auto heights = [](double ascent, double descent) {
        ObjectEntries entries;
        entries.set("ascent", ascent);
        entries.set("descent", descent);
        return Value(std::move(entries));
    };
    ObjectEntries font;
    font.set("family", metrics->family);
    font.set("style", metrics->style);
    ObjectEntries result;
    result.set("nominal", heights(metrics->nominal_ascent, metrics->nominal_descent));
    result.set("max", heights(metrics->max_ascent, metrics->max_descent));
    result.set("interline", metrics->interline);
    result.set("font", Value(std::move(font)));
    return Value(std::move(result));
}

/// The drawing that is asked about; nothing, with a warning, where there is no such file.
std::optional<DrawingQuery> drawing(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    static constexpr std::array<ParameterNames, 5> kParameters{"file", "layer", "origin", "scale", "name"};
    const NamedArguments arguments(a, kParameters, host);
    DrawingQuery query;
    query.file = arguments.text("file");
    query.import.file = host.data_file(query.file);
    if (const Value& origin = arguments["origin"]; !origin.is_undef()) {
        const auto xy = origin.is_vector() ? origin.elements() : std::span<const Value>();
        const auto good = [](const Value& v) { return v.is_number() && std::isfinite(v.number()); };
        if (xy.size() == 2 && good(xy[0]) && good(xy[1])) {
            query.import.origin = {xy[0].number(), xy[1].number()};
        } else {
            host.warn(fmt::format("{}(..., origin={}) could not be converted", name, origin.echo_text()));
        }
    }
    if (std::error_code error; !std::filesystem::exists(query.import.file.path, error)) {
        host.warn(fmt::format("Can't open DXF file '{}'!", query.file));
        return std::nullopt;
    }
    query.import.layer = arguments.text("layer");
    query.import.scale = arguments.number("scale", 1);
    query.dimension = arguments.text("name");
    return query;
}

Value dxf_dim(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    const auto query = drawing(name, a, host);
    const auto result =
        query ? answer(host, name, [&](Measures& m, auto& w) { return m.dimension(*query, w); }) : std::nullopt;
    return result ? Value(*result) : Value();
}

Value dxf_cross(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    const auto query = drawing(name, a, host);
    const auto result =
        query ? answer(host, name, [&](Measures& m, auto& w) { return m.cross(*query, w); }) : std::nullopt;
    return result ? vector_of(*result) : Value();
}

constexpr std::array kMeasures{
    FunctionEntry{"textmetrics", textmetrics},
    FunctionEntry{"fontmetrics", fontmetrics},
    FunctionEntry{"dxf_dim", dxf_dim},
    FunctionEntry{"dxf_cross", dxf_cross},
};

}  // namespace

std::span<const FunctionEntry> measure_functions() {
    return kMeasures;
}

}  // namespace csg::scad
