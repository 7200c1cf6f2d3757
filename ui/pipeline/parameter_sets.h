// Parameter sets: values of parameters under a name, in a file of OpenSCAD's format.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "csg/scad/customizer/customizer.h"

namespace ui {

struct ParameterSet {
    std::string name;
    std::vector<std::pair<std::string, std::string>> values;  ///< Name and csg::scad::set_text() of each parameter.

    /// The value of that name; null where there is none.
    [[nodiscard]] const std::string* find(std::string_view parameter) const;
};

/// The sets of a file, in its order; nothing where the text, which is not empty, is no file of parameter sets.
[[nodiscard]] std::optional<std::vector<ParameterSet>> read_parameter_sets(const std::string& json);

/// name=expression, for each parameter that the set gives a fitting value.
[[nodiscard]] std::vector<std::string> definitions_of(std::span<const csg::scad::CustomizerParameter> parameters,
                                                      const ParameterSet& set);

/// The text of the file with the set in it, in the place of one of that name; all else that it holds stays. Throws
/// std::runtime_error where the text, which is not empty, is no file of parameter sets.
[[nodiscard]] std::string with_parameter_set(const std::string& json, const ParameterSet& set);
/// The same without the set of that name.
[[nodiscard]] std::string without_parameter_set(const std::string& json, const std::string& name);

}  // namespace ui
