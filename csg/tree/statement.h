// The calls in a text that a tree was made by.
#pragma once

#include <cstdint>
#include <string>

#include "csg/tree/source_location.h"

namespace csg {

/// `name(arguments)`, without the children behind it; `if (condition)` is one as well.
struct Statement {
    SourceLocation where;                        ///< Of its first byte: Node::where of all nodes that it made.
    std::uint32_t begin_byte = 0, end_byte = 0;  ///< Offsets in its file; half-open.
    std::string name;                            ///< "translate", "for", "if"; of a user-defined module.
    bool user_module = false;
};

}  // namespace csg
