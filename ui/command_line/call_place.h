// Calls by their place in the text, as options name them.
#pragma once

#include <string>
#include <vector>

#include "csg/tree/tree.h"

namespace ui {

/// Of [FILE:]LINE[:COLUMN]; FILE is the end of a file's path, or the input. The first of these calls on that line, or
/// at that column. Throws UsageError, which tells the nearest, where there is none. `what`: "difference or
/// intersection".
[[nodiscard]] csg::SourceLocation call_at(const csg::Tree& tree, const std::vector<const csg::Statement*>& calls,
                                          const std::string& option, const std::string& text, const char* what);

/// All calls of the tree.
[[nodiscard]] std::vector<const csg::Statement*> all_calls(const csg::Tree& tree);

}  // namespace ui
