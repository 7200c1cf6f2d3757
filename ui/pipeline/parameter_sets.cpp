#include "ui/pipeline/parameter_sets.h"

#include <algorithm>
#include <stdexcept>

#include "ui/pipeline/json.h"

namespace ui {

namespace {

constexpr std::string_view kSets = "parameterSets";

/// Null where the text is no file of parameter sets.
Json read(const std::string& text) {
    constexpr int kDeepest = 100;
    Json json = Json::read(text, kDeepest);
    const Json* sets = json.find(kSets);
    return sets != nullptr && sets->is_object() ? json : Json();
}

/// What is to be changed; a new file where there was none.
Json document(const std::string& text) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
        return Json{{kSets.data(), Json::object()}, {"fileFormatVersion", "1"}};
    }
    Json json = read(text);
    if (json.is_null()) {
        throw std::runtime_error("it is no file of parameter sets");
    }
    return json;
}

}  // namespace

const std::string* ParameterSet::find(std::string_view parameter) const {
    const auto at = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == parameter; });
    return at == values.end() ? nullptr : &at->second;
}

std::optional<std::vector<ParameterSet>> read_parameter_sets(const std::string& text) {
    const Json json = read(text);
    if (json.is_null()) {
        return std::nullopt;
    }
    std::vector<ParameterSet> sets;
    for (const auto& [name, values] : json.find(kSets)->members()) {
        if (!values.is_object()) {
            continue;
        }
        ParameterSet& set = sets.emplace_back();
        set.name = name;
        for (const auto& [parameter, value] : values.members()) {
            set.values.emplace_back(parameter, value.text() != nullptr ? *value.text() : value.dump());
        }
    }
    return sets;
}

std::vector<std::string> definitions_of(std::span<const csg::scad::CustomizerParameter> parameters,
                                        const ParameterSet& set) {
    std::vector<std::string> definitions;
    for (const csg::scad::CustomizerParameter& parameter : parameters) {
        const std::string* const text = set.find(parameter.name);
        const auto value = text != nullptr ? csg::scad::fitted_value(parameter, *text) : std::nullopt;
        if (value) {
            definitions.push_back(parameter.name + '=' + csg::scad::expression_of(*value));
        }
    }
    return definitions;
}

std::string with_parameter_set(const std::string& text, const ParameterSet& set) {
    Json json = document(text);
    Json values = Json::object();
    for (const auto& [name, value] : set.values) {
        values[name] = value;
    }
    json[kSets][set.name] = std::move(values);
    return json.dump(4) + "\n";
}

std::string without_parameter_set(const std::string& text, const std::string& name) {
    Json json = document(text);
    json[kSets].erase(name);
    return json.dump(4) + "\n";
}

}  // namespace ui
