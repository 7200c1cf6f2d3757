// A call of the model's text by its place, which outlives the tree that it is known from.
#pragma once

#include <cstdint>
#include <string>

namespace ui {

struct CallAt {
    std::string name;  ///< "difference"
    std::string file;  ///< As the tree names it.
    std::uint32_t line = 0, column = 0;
    bool operator==(const CallAt&) const = default;
};

}  // namespace ui
