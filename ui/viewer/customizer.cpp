#include "ui/viewer/customizer.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/file.h"

namespace ui {

using csg::scad::expression_of;
using csg::scad::fitted_value;
using csg::scad::set_text;

Customizer::Customizer(std::filesystem::path file) : file_(std::move(file)) {}

void Customizer::receive(std::vector<Parameter> parameters) {
    parameters_ = std::move(parameters);
    std::map<std::string, Parameter::Value> fitting;
    for (const Parameter& parameter : parameters_) {
        const auto chosen = chosen_.find(parameter.name);
        auto value = chosen != chosen_.end() ? fitted_value(parameter, set_text(chosen->second)) : std::nullopt;
        if (value && *value != parameter.initial) {
            fitting.emplace(parameter.name, *std::move(value));
        }
    }
    chosen_ = std::move(fitting);
    read_sets();
    error_ = problem_;
}

void Customizer::set(const std::string& name, Parameter::Value value) {
    const auto parameter = std::ranges::find(parameters_, name, &Parameter::name);
    if (parameter == parameters_.end()) {
        return;
    }
    if (value == parameter->initial) {
        chosen_.erase(name);
    } else {
        chosen_.insert_or_assign(name, std::move(value));
    }
}

void Customizer::reset(const std::string& name) {
    if (name.empty()) {
        chosen_.clear();
        used_.clear();
    } else {
        chosen_.erase(name);
    }
}

void Customizer::use(const std::string& name) {
    const auto set = std::ranges::find(sets_, name, &ParameterSet::name);
    if (set == sets_.end()) {
        return;
    }
    chosen_.clear();
    used_ = name;
    for (const Parameter& parameter : parameters_) {
        const std::string* const text = set->find(parameter.name);
        auto value = text != nullptr ? fitted_value(parameter, *text) : std::nullopt;
        if (value && *value != parameter.initial) {
            chosen_.emplace(parameter.name, *std::move(value));
        }
    }
}

void Customizer::save(const std::string& name) {
    ParameterSet set{name, {}};
    for (const Parameter& parameter : parameters_) {
        set.values.emplace_back(parameter.name, set_text(value(parameter)));
    }
    write_sets([&](const std::string& text) { return with_parameter_set(text, set); });
    if (error_.empty()) {
        used_ = name;
    }
}

void Customizer::remove(const std::string& name) {
    write_sets([&](const std::string& text) { return without_parameter_set(text, name); });
    if (error_.empty() && used_ == name) {
        used_.clear();
    }
}

const Customizer::Parameter::Value& Customizer::value(const Parameter& parameter) const {
    const auto chosen = chosen_.find(parameter.name);
    return chosen == chosen_.end() ? parameter.initial : chosen->second;
}

bool Customizer::changed(const Parameter& parameter) const {
    return chosen_.contains(parameter.name);
}

std::vector<std::string> Customizer::definitions() const {
    std::vector<std::string> definitions;
    for (const auto& [name, value] : chosen_) {
        definitions.push_back(name + '=' + expression_of(value));
    }
    return definitions;
}

void Customizer::read_sets() {
    // Of each revision; while a slider is dragged there are many.
    const csg::scad::DiskState now = csg::scad::disk_state(file_.string());
    if (std::exchange(read_, now) == now) {
        return;
    }
    sets_.clear();
    problem_.clear();
    const auto text = base::read_regular_file(file_);
    if (!text) {
        return;
    }
    if (auto sets = read_parameter_sets(*text)) {
        sets_ = *std::move(sets);
    } else {
        problem_ = fmt::format("{} is no file of parameter sets", file_.filename().string());
    }
}

/// What somebody else wrote since it was read stays.
template <typename Change>
void Customizer::write_sets(const Change& change) {
    std::string error;
    try {
        base::write_file(file_, change(base::read_regular_file(file_).value_or("")));
    } catch (const std::runtime_error& problem) {
        error = fmt::format("{}: {}", file_.filename().string(), problem.what());
    }
    read_sets();
    error_ = error.empty() ? problem_ : error;
}

}  // namespace ui
