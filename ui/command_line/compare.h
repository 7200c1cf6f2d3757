// csgscope compare: the picture against the exact mesh, against another program's mesh, or against a picture.
#pragma once

#include <string>
#include <vector>

namespace ui {

/// Runs with the arguments after "compare". 0: within the tolerance; 1: beyond it. Throws as the program's other
/// commands do.
int run_compare(const std::vector<std::string>& arguments);

}  // namespace ui
