#include "ui/command_line/parameters.h"

#include <fmt/format.h>

#include <variant>

#include "csg/scad/customizer/customizer.h"
#include "ui/pipeline/json.h"

namespace ui {

namespace {

using csg::scad::CustomizerParameter;

struct JsonOf {
    Json operator()(const std::vector<double>& numbers) const {
        Json array = Json::array();
        for (const double number : numbers) {
            array.push_back(number);
        }
        return array;
    }
    Json operator()(const auto& value) const { return value; }
};

/// Members by name, as OpenSCAD writes them.
Json to_json(const CustomizerParameter& p) {
    Json json = Json::object();
    if (!p.caption.empty()) {
        json["caption"] = p.caption;
    }
    json["group"] = p.group;
    json["initial"] = std::visit(JsonOf(), p.initial);
    if (p.maximum) {
        json["max"] = *p.maximum;
    }
    if (p.longest) {
        json["maxLength"] = *p.longest;
    }
    if (p.minimum) {
        json["min"] = *p.minimum;
    }
    json["name"] = p.name;
    for (const auto& option : p.options) {
        json["options"].push_back({{"name", option.label}, {"value", std::visit(JsonOf(), option.value)}});
    }
    if (p.step) {
        json["step"] = *p.step;
    }
    json["type"] = std::holds_alternative<bool>(p.initial)          ? "boolean"
                   : std::holds_alternative<std::string>(p.initial) ? "string"
                                                                    : "number";
    return json;
}

}  // namespace

std::string parameters_json(const csg::scad::Program& program, const std::string& title) {
    Json parameters = Json::array();
    for (const CustomizerParameter& p : csg::scad::customizer_parameters(program)) {
        parameters.push_back(to_json(p));
    }
    return Json{{"parameters", parameters}, {"title", title}}.dump(2) + "\n";
}

ParameterSet read_parameter_set(const csg::scad::Program& program, const std::string& text, const std::string& path,
                                const std::string& name) {
    constexpr int kDeepest = 100;
    const Json json = Json::read(text, kDeepest);
    const Json* sets = json.find("parameterSets");
    if (sets == nullptr || !sets->is_object()) {
        return {{}, fmt::format("Parameter file '{}' holds no parameter sets", path)};
    }
    const Json* set = sets->find(name);
    if (set == nullptr || !set->is_object()) {
        return {{}, fmt::format("There is no parameter set '{}' in '{}'", name, path)};
    }
    ParameterSet result;
    for (const CustomizerParameter& p : csg::scad::customizer_parameters(program)) {
        const Json* value = set->find(p.name);
        if (value == nullptr) {
            continue;
        }
        if (const auto expression = fitted_expression(p, value->text() != nullptr ? *value->text() : value->dump())) {
            result.definitions.push_back(p.name + '=' + *expression);
        }
    }
    return result;
}

}  // namespace ui
