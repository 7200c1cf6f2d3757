// The built-in functions of the language.
#pragma once

#include <functional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/value.h"

namespace csg::scad {

/// What a built-in function may use besides its arguments.
struct FunctionHost {
    std::function<void(std::string text)> warn;  ///< At the place of the call.
    std::function<void(std::string text)> warn_without_place;
    std::vector<std::string_view> module_names;  ///< Of the user modules that run, the outermost first.
    std::mt19937 random;                         ///< For rands() without a seed: the same in every run.
    std::size_t max_elements = 0;                ///< Of a list that a function makes.
};

/// Never throws on bad arguments: warns and gives undef, as OpenSCAD does.
using BuiltinFunction = Value (*)(std::string_view name, std::span<const Value> arguments, FunctionHost& host);

struct FunctionEntry {
    std::string_view name;
    BuiltinFunction function;
};

[[nodiscard]] std::span<const FunctionEntry> math_functions();
[[nodiscard]] std::span<const FunctionEntry> list_functions();

/// Null where there is none of that name.
[[nodiscard]] BuiltinFunction find_builtin_function(std::string_view name);

// Checks that built-ins share. Each warns as OpenSCAD does where it fails.

/// `expected`: as printed, "1" or "3 or 4".
[[nodiscard]] bool check_count(std::string_view name, std::span<const Value> arguments, std::size_t at_least,
                               std::size_t at_most, std::string_view expected, FunctionHost& host);
[[nodiscard]] bool check_type(std::string_view name, std::span<const Value> arguments, std::size_t index,
                              ValueType expected, FunctionHost& host);

}  // namespace csg::scad
