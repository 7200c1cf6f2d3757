// A difference or an intersection whose effect is shown.
#pragma once

#include <cstdint>
#include <string>

namespace ui {

/// By its place, which outlives the tree that it is known from.
struct ExplainedCall {
    std::string name;  ///< "difference"
    std::string file;  ///< As the tree names it.
    std::uint32_t line = 0, column = 0;
};

}  // namespace ui
