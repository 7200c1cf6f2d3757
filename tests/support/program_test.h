// A fixture for tests that run the program as its users do. For targets with PROGRAM (tests/CMakeLists.txt).
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/temporary_folder.h"

namespace test_support {

/// Each test has a folder of its own, in which the program runs, with a small model: m.scad.
class ProgramTest : public testing::Test {
  public:
    struct Result {
        int status = -1;  ///< Exit status; -1 where a signal or the time limit ended it.
        std::string out, err;
    };

  protected:
    /// `most_seconds`: time limit of a run.
    explicit ProgramTest(int most_seconds) : most_seconds_(most_seconds) {
        folder_.write("m.scad", "difference() { cube(10, center = true); sphere(6, $fn = 24); }\n");
    }

    /// `arguments` as for a shell; `before` stands before the program's name.
    [[nodiscard]] Result run(const std::string& arguments, const std::string& before = "") const {
        return run_program(CSGSCOPE_PROGRAM, arguments, before);
    }
    /// Another program; its path is absolute, or seen from the test's folder.
    [[nodiscard]] Result run_program(const std::string& program, const std::string& arguments,
                                     const std::string& before = "") const {
        const std::string command = "cd '" + folder_.path("") + "' && " + before + " timeout " +
                                    std::to_string(most_seconds_) + " '" + program + "' " + arguments +
                                    " >out.txt 2>err.txt";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) && WEXITSTATUS(status) < 124 ? WEXITSTATUS(status) : -1, folder_.read("out.txt"),
                folder_.read("err.txt")};
    }

    TemporaryFolder folder_;

  private:
    int most_seconds_;
};

}  // namespace test_support
