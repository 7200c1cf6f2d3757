#include "ui/command_line/parameters.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "csg/scad/customizer/customizer.h"

namespace ui {

namespace {

using Json = nlohmann::json;
using csg::scad::CustomizerParameter;

Json to_json(const CustomizerParameter& p) {
    Json json{{"name", p.name}, {"group", p.group}};
    std::visit([&](const auto& initial) { json["initial"] = initial; }, p.initial);
    json["type"] = std::holds_alternative<bool>(p.initial)          ? "boolean"
                   : std::holds_alternative<std::string>(p.initial) ? "string"
                                                                    : "number";
    if (!p.caption.empty()) {
        json["caption"] = p.caption;
    }
    for (const auto& [key, number] :
         {std::pair("min", p.minimum), std::pair("max", p.maximum), std::pair("step", p.step)}) {
        if (number) {
            json[key] = *number;
        }
    }
    if (p.longest) {
        json["maxLength"] = *p.longest;
    }
    for (const auto& option : p.options) {
        Json value;
        std::visit([&](const auto& v) { value = v; }, option.value);
        json["options"].push_back({{"name", option.label}, {"value", value}});
    }
    return json;
}

}  // namespace

std::string parameters_json(const csg::scad::Program& program, const std::string& title) {
    Json json{{"title", title}, {"parameters", Json::array()}};
    for (const CustomizerParameter& p : csg::scad::customizer_parameters(program)) {
        json["parameters"].push_back(to_json(p));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ParameterSet read_parameter_set(const csg::scad::Program& program, const std::string& text, const std::string& path,
                                const std::string& name) {
    // Nesting is bounded: the parser of the library needs no stack, but destroying what it made does.
    constexpr int kDeepest = 100;
    const Json json = Json::parse(
        text, [](int depth, Json::parse_event_t, Json&) { return depth < kDeepest; }, false);
    if (!json.is_object() || !json.contains("parameterSets") || !json["parameterSets"].is_object()) {
        return {{}, fmt::format("Parameter file '{}' holds no parameter sets", path)};
    }
    const Json& sets = json["parameterSets"];
    if (!sets.contains(name) || !sets[name].is_object()) {
        return {{}, fmt::format("There is no parameter set '{}' in '{}'", name, path)};
    }
    ParameterSet result;
    for (const CustomizerParameter& p : csg::scad::customizer_parameters(program)) {
        const auto value = sets[name].find(p.name);
        if (value == sets[name].end()) {
            continue;
        }
        if (const auto expression =
                fitted_expression(p, value->is_string() ? value->get<std::string>() : value->dump())) {
            result.definitions.push_back(p.name + '=' + *expression);
        }
    }
    return result;
}

}  // namespace ui
