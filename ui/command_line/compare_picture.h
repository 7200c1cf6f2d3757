// csgscope compare --against FILE.png: picture to picture.
#pragma once

#include "ui/command_line/compare_options.h"

namespace ui {

/// 0: within the threshold; 1: beyond it.
[[nodiscard]] int compare_with_picture(const CompareOptions& options);

}  // namespace ui
