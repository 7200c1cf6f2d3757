#include "csg/scad/builtin/named_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <string>
#include <vector>

namespace csg::scad {

NamedArguments::NamedArguments(std::span<const Value> arguments, std::span<const std::string_view> parameters,
                               FunctionHost& host)
    : parameters_(parameters) {
    std::bitset<kMost> by_name, by_position;
    std::vector<std::string_view> unknown;
    std::size_t position = 0;
    bool too_many = false;
    const auto supplied_again = [&](std::string_view name) {
        host.warn(fmt::format("argument \"{}\" supplied more than once", name));
    };
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view name = host.argument_name(i);
        if (name.empty()) {
            while (position < parameters.size() && by_name[position]) {
                ++position;
            }
            if (position < parameters.size()) {
                by_position[position] = true;
                values_[position++] = arguments[i];
            } else if (!too_many) {
                too_many = true;
                host.warn("Too many unnamed arguments supplied");
            }
            continue;
        }
        const std::size_t index = index_of(name);
        if (index == kMost) {
            if (std::find(unknown.begin(), unknown.end(), name) != unknown.end()) {
                supplied_again(name);
            } else if (!name.starts_with('$')) {
                host.warn(fmt::format("variable \"{}\" not specified as parameter", name));
            }
            unknown.push_back(name);
            continue;
        }
        if (by_name[index]) {
            supplied_again(name);
        } else if (by_position[index]) {
            host.warn(fmt::format("argument \"{}\" overrides positional argument", name));
        }
        by_name[index] = true;
        values_[index] = arguments[i];
    }
}

std::size_t NamedArguments::index_of(std::string_view parameter) const {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        if (parameters_[i] == parameter) {
            return i;
        }
    }
    return kMost;
}

const Value& NamedArguments::operator[](std::string_view parameter) const {
    return values_[index_of(parameter)];
}

std::string NamedArguments::text(std::string_view parameter) const {
    const Value& value = (*this)[parameter];
    return value.is_string() ? value.string() : std::string();
}

double NamedArguments::number(std::string_view parameter, double otherwise) const {
    const Value& value = (*this)[parameter];
    return value.is_number() ? value.number() : otherwise;
}

}  // namespace csg::scad
