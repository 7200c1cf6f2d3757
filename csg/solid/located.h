// Warnings with their place.
#pragma once

#include <string>

#include "csg/tree/tree.h"

namespace csg::solid {

/// "file:line: text"; the bare text where there is no place.
[[nodiscard]] inline std::string located(const Tree& tree, const SourceLocation& where, const std::string& text) {
    if (where.file >= tree.files().size()) {
        return text;
    }
    return tree.files()[where.file] + ":" + std::to_string(where.line) + ": " + text;
}

}  // namespace csg::solid
