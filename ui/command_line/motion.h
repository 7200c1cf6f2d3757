// csgscope motion: what of a model moves while $t runs, when and how far.
#pragma once

#include <string>
#include <vector>

namespace ui {

/// The arguments behind "motion". 0, or 1 where the input is bad or the time was over; a message says so.
[[nodiscard]] int run_motion(const std::vector<std::string>& arguments);

}  // namespace ui
