// Arguments of built-in functions that have named parameters.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "csg/scad/builtin/builtin_functions.h"

namespace csg::scad {

/// Arguments of the call that runs, matched to parameters, which may stand without their names in this order. Warns of
/// names that are no parameter, and of too many arguments.
class NamedArguments {
  public:
    /// The parameters must outlive it.
    NamedArguments(std::span<const Value> arguments, std::span<const std::string_view> parameters, FunctionHost& host);

    /// undef where it is not given, or is no parameter.
    [[nodiscard]] const Value& operator[](std::string_view parameter) const;

    // What is given with another type counts as not given.
    [[nodiscard]] std::string text(std::string_view parameter) const;
    [[nodiscard]] double number(std::string_view parameter, double otherwise) const;

  private:
    static constexpr std::size_t kMost = 12;
    [[nodiscard]] std::size_t index_of(std::string_view parameter) const;

    std::span<const std::string_view> parameters_;
    std::array<Value, kMost + 1> values_;  ///< The last is for what there is not.
};

}  // namespace csg::scad
