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
    using Value = std::variant<bool, double, std::string, std::vector<double>>;
    struct Option {
        std::string label;
        std::variant<double, std::string> value;
    };
    std::string name;
    std::string caption;  ///< May be empty.
    std::string group;    ///< "Parameters" where no comment names one.
    Value initial;
    std::vector<Option> options;  ///< Not empty: one of these, and nothing else.
    std::optional<double> minimum, maximum, step;
    std::optional<std::size_t> longest;  ///< Of a text.
};

/// In the order of the file. Those of the group "Hidden" are left out, as is whatever is no bool, number, text, or list
/// of one to four numbers. Empty where the main file did not parse.
[[nodiscard]] std::vector<CustomizerParameter> customizer_parameters(const Program& program);

/// The value for `parameter` that a parameter set holds as text: numbers are clamped. Nothing where the text does not
/// fit, which leaves the parameter as it is.
[[nodiscard]] std::optional<CustomizerParameter::Value> fitted_value(const CustomizerParameter& parameter,
                                                                     std::string_view text);

/// The value as an expression of the language.
[[nodiscard]] std::string expression_of(const CustomizerParameter::Value& value);
/// The value as parameter sets hold it: as an expression, but texts without quotes.
[[nodiscard]] std::string set_text(const CustomizerParameter::Value& value);

}  // namespace csg::scad
