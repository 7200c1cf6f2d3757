// csgscope check: faults of a model, for people and for continuous integration.
#pragma once

#include <string>
#include <vector>

namespace ui {

/// The arguments behind "check". 0: nothing was found, 1: something was, 2: the input is bad, or the time was over; a
/// message says so.
[[nodiscard]] int run_check(const std::vector<std::string>& arguments);

}  // namespace ui
