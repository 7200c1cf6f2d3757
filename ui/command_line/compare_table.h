// What csgscope compare has found, as a text for people.
#pragma once

#include <string>
#include <vector>

#include "ui/pipeline/json.h"

namespace ui {

/// `found`: as it is written with --json, of a comparison with a mesh.
[[nodiscard]] std::string compare_table(const Json& found);

/// Lines of cells: the first column to the left, the others to the right.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& rows);

/// With three digits, where it is no whole number.
[[nodiscard]] std::string short_number(const Json& value);

/// The same as compare_table of a comparison with a picture.
[[nodiscard]] std::string compare_picture_text(const Json& found);

}  // namespace ui
