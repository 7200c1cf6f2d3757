// What arguments of assignments and assertions stand for.
#pragma once

#include <algorithm>
#include <span>

#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// Whether one of the arguments before `a`, which is one of them, has its name.
[[nodiscard]] inline bool is_repeated(std::span<const Argument> arguments, const Argument& a) {
    return std::any_of(arguments.data(), &a, [&](const Argument& before) { return before.name == a.name; });
}

/// Of an assertion; null where it has none.
struct AssertionParts {
    const Argument* condition = nullptr;
    const Argument* message = nullptr;
};

[[nodiscard]] inline AssertionParts assertion_of(const Program& program, std::span<const Argument> arguments) {
    AssertionParts parts;
    for (const Argument& a : arguments) {
        const bool is_message =
            a.name == kNoSymbol ? parts.condition != nullptr : program.symbols.text(a.name) == "message";
        (is_message ? parts.message : parts.condition) = &a;
    }
    return parts;
}

}  // namespace csg::scad
