// The program without its window: reads the command line, makes the files.
#pragma once

#include <string>
#include <vector>

namespace ui {

/// Gives the exit status: 0, or 1 with a message on standard error.
[[nodiscard]] int run(const std::vector<std::string>& arguments);

}  // namespace ui
