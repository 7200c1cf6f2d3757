// How far a name is from what somebody typed.
#pragma once

#include <cstddef>
#include <string_view>

namespace npr {

/// Levenshtein's distance: the least number of characters inserted, left out or replaced.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace npr
