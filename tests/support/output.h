// Where programs for measuring put their results.
#pragma once

#include <iostream>
#include <string>

#include "base/file.h"

namespace test_support {

/// Into the file; "-" is standard output, and "" nowhere.
inline void write_output(const std::string& path, const std::string& text) {
    if (path == "-") {
        std::cout << text << '\n';
    } else if (!path.empty()) {
        base::write_file(path, text);
    }
}

}  // namespace test_support
