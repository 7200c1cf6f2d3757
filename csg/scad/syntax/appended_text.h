// Definitions from outside that are more than assignments: the newest OpenSCAD takes -D as text behind the main file's.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace csg::scad {

/// Whether one of the texts is more than assignments, which syntax/definitions.h takes without parsing a file again:
/// calls, definitions of modules and functions, `use`. What is no statement at all is not.
[[nodiscard]] bool has_statements(std::span<const std::string> definitions);

/// Where one of them is more than assignments, all of them become lines behind the text, each with a semicolon after
/// it; then none are left.
void append_statements(std::string& text, std::vector<std::string>& definitions);

}  // namespace csg::scad
