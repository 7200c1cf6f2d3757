// What the command line says of models of transparency (`--transparency`).
#pragma once

#include <string>

#include "npr/picture.h"

namespace ui {

/// `text`: NAME[:KEY=VALUE,…] of a model and its parameters; empty leaves the picture as it is. Throws UsageError.
void read_transparency(npr::Picture& picture, const std::string& text);

/// `text`: SRC,DST[,EQUATION[,SRC,DST,EQUATION]], the last three of alpha; for `sorted`. The same.
void read_blend(npr::Picture& picture, const std::string& text);

}  // namespace ui
