#include "npr/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "npr/edit_distance.h"

namespace npr {
namespace {

template <typename T>
std::optional<T> parse(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

std::optional<bool> parse_toggle(std::string_view text) {
    if (text == "on" || text == "true" || text == "1") {
        return true;
    }
    if (text == "off" || text == "false" || text == "0") {
        return false;
    }
    return std::nullopt;
}

std::optional<glm::vec3> parse_color(std::string_view text) {
    if ((text.size() != 4 && text.size() != 7) || text[0] != '#') {
        return std::nullopt;
    }
    unsigned hex = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), hex, 16);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    if (text.size() == 4) {
        return glm::vec3(hex >> 8 & 15U, hex >> 4 & 15U, hex & 15U) / 15.0F;
    }
    return glm::vec3(hex >> 16 & 255U, hex >> 8 & 255U, hex & 255U) / 255.0F;
}

std::optional<Value> parse_value(const Parameter& p, std::string_view text) {
    switch (p.kind) {
        case ParameterKind::Number:
            return parse<float>(text);
        case ParameterKind::Integer:
            return parse<int>(text);
        case ParameterKind::Toggle:
            return parse_toggle(text);
        case ParameterKind::Color:
            return parse_color(text);
        case ParameterKind::Choice:
            break;
    }
    const auto found = std::find(p.choices.begin(), p.choices.end(), text);
    if (found == p.choices.end()) {
        return std::nullopt;
    }
    return static_cast<int>(found - p.choices.begin());
}

bool valid(const Parameter& p, const Value& value) {
    if (value.index() != p.initial.index()) {
        return false;
    }
    if (const float* f = std::get_if<float>(&value)) {
        return p.is_length ? *f >= 0 && *f <= Parameter::kLongest : *f >= p.min && *f <= p.max;
    }
    if (const int* i = std::get_if<int>(&value)) {
        if (p.kind == ParameterKind::Choice) {
            return *i >= 0 && *i < static_cast<int>(p.choices.size());
        }
        return static_cast<float>(*i) >= p.min && static_cast<float>(*i) <= p.max;
    }
    if (const glm::vec3* c = std::get_if<glm::vec3>(&value)) {
        return glm::all(glm::greaterThanEqual(*c, glm::vec3(0))) && glm::all(glm::lessThanEqual(*c, glm::vec3(1)));
    }
    return true;
}

std::string takes(const Parameter& p) {
    switch (p.kind) {
        case ParameterKind::Number:
            return p.is_length
                       ? fmt::format("a length up to {} in pixels, or in millimeters as 0.35mm", Parameter::kLongest)
                       : fmt::format("a number from {} to {}", p.min, p.max);
        case ParameterKind::Integer:
            return fmt::format("a whole number from {} to {}", p.min, p.max);
        case ParameterKind::Toggle:
            return "on or off";
        case ParameterKind::Color:
            return "a color as #rrggbb";
        case ParameterKind::Choice:
            break;
    }
    return fmt::format("one of {}", fmt::join(p.choices, ", "));
}

}  // namespace

Parameter Parameter::number(std::string_view name, std::string_view label, float initial, float min, float max) {
    return {name, label, ParameterKind::Number, initial, min, max, {}};
}
Parameter Parameter::length(std::string_view name, std::string_view label, float initial, float min, float max) {
    Parameter p = number(name, label, initial, min, max);
    p.is_length = true;
    return p;
}
Parameter Parameter::integer(std::string_view name, std::string_view label, int initial, int min, int max) {
    return {name, label, ParameterKind::Integer, initial, static_cast<float>(min), static_cast<float>(max), {}};
}
Parameter Parameter::toggle(std::string_view name, std::string_view label, bool initial) {
    return {name, label, ParameterKind::Toggle, initial, 0, 1, {}};
}
Parameter Parameter::color(std::string_view name, std::string_view label, const glm::vec3& initial) {
    return {name, label, ParameterKind::Color, initial, 0, 1, {}};
}
Parameter Parameter::choice(std::string_view name, std::string_view label, int initial,
                            std::vector<std::string_view> choices) {
    const auto last = static_cast<float>(choices.size()) - 1;
    return {name, label, ParameterKind::Choice, initial, 0, last, std::move(choices)};
}

Parameters::Parameters(std::span<const Parameter> parameters) : first_(parameters.data()) {
    for (const Parameter& p : parameters) {
        values_.push_back(p.initial);
        millimeters_.push_back(false);
    }
}

std::optional<std::size_t> Parameters::find(std::string_view name) const {
    const auto all = list();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == name; });
    return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

std::size_t Parameters::index(std::string_view name) const {
    if (const auto found = find(name)) {
        return *found;
    }
    const auto all = list();
    if (all.empty()) {
        throw std::invalid_argument(fmt::format("no parameter \"{}\"; this style has none", name));
    }
    const auto nearest = std::min_element(all.begin(), all.end(), [&](const Parameter& a, const Parameter& b) {
        return edit_distance(a.name, name) < edit_distance(b.name, name);
    });
    throw std::invalid_argument(fmt::format("no parameter \"{}\"; did you mean \"{}\"?", name, nearest->name));
}

void Parameters::set(std::size_t i, const Value& value) {
    const Parameter& p = list()[i];
    if (!valid(p, value)) {
        throw std::invalid_argument(fmt::format("{} takes {}", p.name, takes(p)));
    }
    values_[i] = value;
    millimeters_[i] = false;
}

void Parameters::read(std::string_view name, std::string_view text) {
    const std::size_t i = index(name);
    const Parameter& p = list()[i];
    const bool millimeters = p.is_length && text.ends_with("mm");
    const bool unit = millimeters || (p.is_length && text.ends_with("px"));
    const std::optional<Value> value = parse_value(p, unit ? text.substr(0, text.size() - 2) : text);
    if (!value || !valid(p, *value)) {
        throw std::invalid_argument(fmt::format("{} takes {}, not \"{}\"", name, takes(p), text));
    }
    values_[i] = *value;
    millimeters_[i] = millimeters;
}

std::string text(const Parameter& parameter, const Value& value) {
    if (const float* f = std::get_if<float>(&value)) {
        return fmt::format("{}", *f);
    }
    if (const bool* b = std::get_if<bool>(&value)) {
        return *b ? "on" : "off";
    }
    if (const glm::vec3* c = std::get_if<glm::vec3>(&value)) {
        const auto byte = [](float v) { return static_cast<int>(std::lround(v * 255.0F)); };
        return fmt::format("#{:02x}{:02x}{:02x}", byte(c->x), byte(c->y), byte(c->z));
    }
    const int i = std::get<int>(value);
    return parameter.kind == ParameterKind::Choice ? std::string(parameter.choices[static_cast<std::size_t>(i)])
                                                   : fmt::format("{}", i);
}

}  // namespace npr
