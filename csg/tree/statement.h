// The calls in a text that a tree was made by.
#pragma once

#include <cstdint>
#include <string>

#include "csg/tree/source_location.h"

namespace csg {

/// `name(arguments)`, without the children behind it; `if (condition)` is one as well.
struct Statement {
    SourceLocation where;                        ///< Of its first byte: Node::where of all nodes that it made.
    std::uint32_t end_line = 0, end_column = 0;  ///< One past its last byte, counted as in `where`.
    std::string name;                            ///< "translate", "for", "if"; of a user-defined module.
    bool user_module = false;
};

}  // namespace csg
