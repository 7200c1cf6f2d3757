#include "ui/command_line/parameters_json.h"

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

}  // namespace ui
