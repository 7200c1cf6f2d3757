// The built-in functions of the language.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/builtin/seeded_random.h"
#include "csg/scad/source/source.h"
#include "csg/scad/value/value.h"
#include "csg/tree/leaf_shape.h"

namespace csg::scad {

class Measures;

/// What a built-in function may use besides its arguments.
struct FunctionHost {
    std::function<void(std::string text)> warn;  ///< At the place of the call.
    std::function<void(std::string text)> warn_without_place;
    /// Of an argument of the call; empty for one without. Most functions do not look at names.
    std::function<std::string_view(std::size_t argument)> argument_name;
    /// Where a file is that the call names, as import() finds it.
    std::function<FileStamp(const std::string& name)> data_file;
    SourceReader read;
    std::map<std::string, Value> imported;       ///< What import() gave, by path: a file is read once.
    Measures* measures = nullptr;                ///< Null where nobody answers.
    std::vector<std::string> font_files;         ///< Of `use <font.ttf>`.
    std::vector<std::string_view> module_names;  ///< Of the user modules that run, the outermost first.
    SeededRandom random;                         ///< For rands(): the same in every run until it is given a seed.
    std::uint64_t effects = 0;                   ///< Grows with all that would be otherwise were it done twice.
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
[[nodiscard]] std::span<const FunctionEntry> object_functions();
[[nodiscard]] std::span<const FunctionEntry> measure_functions();

/// Null where there is none of that name.
[[nodiscard]] BuiltinFunction find_builtin_function(std::string_view name);

// Checks that built-ins share. Each warns as OpenSCAD does where it fails.

/// `expected`: as printed, "1" or "3 or 4".
[[nodiscard]] bool check_count(std::string_view name, std::span<const Value> arguments, std::size_t at_least,
                               std::size_t at_most, std::string_view expected, FunctionHost& host);
[[nodiscard]] bool check_type(std::string_view name, std::span<const Value> arguments, std::size_t index,
                              ValueType expected, FunctionHost& host, std::string_view what = "argument");

}  // namespace csg::scad
