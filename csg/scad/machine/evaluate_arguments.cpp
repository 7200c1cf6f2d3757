// Which argument of a call is for which parameter.
#include <algorithm>

#include "csg/scad/machine/evaluator.h"

namespace csg::scad {

void Evaluator::bind_arguments(std::span<const Argument> arguments, Value* values, std::span<const Argument> parameters,
                               const SourceRange& where, Value* slots, Dynamics& dynamics,
                               std::vector<std::pair<Symbol, Value>>* others) {
    std::uint64_t by_name = 0;  // Of the first 64 parameters.
    std::uint64_t by_position = 0;
    const auto bit = [](std::size_t i) { return i < 64 ? std::uint64_t{1} << i : 0; };
    std::size_t position = 0;
    bool too_many = false;
    std::vector<Symbol> unknown;
    for (const Argument& a : arguments) {
        Value& value = *values++;
        if (a.name == kNoSymbol) {
            while (position < parameters.size() && (by_name & bit(position)) != 0) {
                ++position;
            }
            if (position < parameters.size()) {
                by_position |= bit(position);
                slots[position++] = std::move(value);
            } else if (!too_many && request_.check_parameters) {
                too_many = true;
                warn(where, "Too many unnamed arguments supplied");
            }
            continue;
        }
        std::size_t i = 0;
        while (i < parameters.size() && parameters[i].name != a.name) {
            ++i;
        }
        if (i < parameters.size()) {
            if ((by_name & bit(i)) != 0) {
                warn(where, fmt::format("argument \"{}\" supplied more than once", name(a.name)));
            } else if ((by_position & bit(i)) != 0) {
                warn(where, fmt::format("argument \"{}\" overrides positional argument", name(a.name)));
            }
            by_name |= bit(i);
            slots[i] = std::move(value);
        } else if (dynamic_name(a.name)) {
            const std::uint32_t slot = r_.argument_slots[index_of(a)];
            for (const auto& d : dynamics) {
                if (d.first == slot) {
                    warn(where, fmt::format("argument \"{}\" supplied more than once", name(a.name)));
                }
            }
            dynamics.emplace_back(slot, std::move(value));
        } else {
            const bool again = std::find(unknown.begin(), unknown.end(), a.name) != unknown.end();
            if (again || request_.check_parameters) {
                warn(where, again ? fmt::format("argument \"{}\" supplied more than once", name(a.name))
                                  : fmt::format("variable \"{}\" not specified as parameter", name(a.name)));
            }
            unknown.push_back(a.name);
            if (others != nullptr) {
                others->emplace_back(a.name, std::move(value));
            }
        }
    }
}

}  // namespace csg::scad
