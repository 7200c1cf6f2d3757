// Arguments of a program as exec and posix_spawn take them.
#pragma once

#include <string>
#include <vector>

namespace base {

/// Pointers into the words, and a null pointer behind them; good as long as these stay as they are.
[[nodiscard]] inline std::vector<char*> program_arguments(std::vector<std::string>& words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    return arguments;
}

}  // namespace base
