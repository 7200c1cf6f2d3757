// The parameters of the main file as a customizer shows them, and values of parameter sets fitted to them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "csg/scad/syntax/ast.h"

namespace csg::scad {

struct CustomizerParameter {
    using Initial = std::variant<bool, double, std::string, std::vector<double>>;
    struct Option {
        std::string label;
        std::variant<double, std::string> value;
    };
    std::string name;
    std::string caption;  ///< May be empty.
    std::string group;    ///< "Parameters" where no comment names one.
    Initial initial;
    std::vector<Option> options;  ///< Not empty: one of these, and nothing else.
    std::optional<double> minimum, maximum, step;
    std::optional<std::size_t> longest;  ///< Of a text.
};

/// In the order of the file. Those of the group "Hidden" are left out, as is whatever is no bool, number, text, or list
/// of one to four numbers. Empty where the main file did not parse.
[[nodiscard]] std::vector<CustomizerParameter> customizer_parameters(const Program& program);

/// The expression that gives `parameter` the value that a parameter set holds as text: numbers are clamped. Nothing
/// where the text does not fit, which leaves the parameter as it is.
[[nodiscard]] std::optional<std::string> fitted_expression(const CustomizerParameter& parameter, std::string_view text);

}  // namespace csg::scad
