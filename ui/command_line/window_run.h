// The run that opens a window.
#pragma once

#include "ui/command_line/options.h"

namespace ui {

/// Is there a display to open it on?
[[nodiscard]] bool has_display();

/// Opens the window, and gives the exit status when it is closed. Throws UsageError where the options ask for what is
/// of pictures, or for a file that cannot be read.
int open_window(const Options& options);

}  // namespace ui
