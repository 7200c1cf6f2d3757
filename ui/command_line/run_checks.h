// Options that do not go together.
#pragma once

#include "npr/picture.h"
#include "ui/command_line/options.h"

namespace ui {

/// Throws UsageError where what is asked for has no meaning; `picture`: what the options ask of pictures.
void check_combinations(const Options& options, const npr::Picture& picture);

/// What the picture asks for and no style of it draws, as a warning; empty where there is none.
[[nodiscard]] std::string ignored_transparency(const npr::Picture& picture);

}  // namespace ui
