// What a program is to say of what it cannot do.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace test_support {

/// Runs each of the arguments by `run` (see ProgramTest): it ends with 1, and says something that holds the text.
template <typename Run>
void expect_refused(Run&& run, const std::vector<std::pair<std::string, std::string>>& wrong) {
    for (const auto& [arguments, part] : wrong) {
        const auto result = run(arguments);
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_NE(result.err.find(part), std::string::npos) << arguments << ": " << result.err;
    }
}

}  // namespace test_support
