// Where something stands in a source text.
#pragma once

#include <compare>
#include <cstdint>

namespace csg {

/// A place in a source file. `line` and `column` count from 1; line 0 means "no place". `file` indexes the file
/// names of the Tree (or of the diagnostics) that the location belongs to.
struct SourceLocation {
    std::uint32_t file = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;

    [[nodiscard]] bool known() const { return line != 0; }
    /// By file, line and column.
    auto operator<=>(const SourceLocation&) const = default;
};

}  // namespace csg
