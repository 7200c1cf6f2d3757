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

    /// With streams of the caller's instead of files: `redirections` as for a shell. The exit status as the shell gives
    /// it (128 and the signal, where one ended it); -1 where the time limit did.
    [[nodiscard]] int status_of(const std::string& arguments, const std::string& redirections,
                                const std::string& before = "") const {
        const std::string command = "cd '" + folder_.path("") + "' && " + before + " timeout " +
                                    std::to_string(most_seconds_) + " '" CSGSCOPE_PROGRAM "' " + arguments + " " +
                                    redirections;
        const int status = std::system(command.c_str());
        return WIFEXITED(status) && WEXITSTATUS(status) != 124 ? WEXITSTATUS(status) : -1;
    }
    /// With an open file as standard error.
    [[nodiscard]] int status_with_standard_error(const std::string& arguments, int fd) const {
        return status_of(arguments, "2>&" + std::to_string(fd));
    }

    TemporaryFolder folder_;

  private:
    int most_seconds_;
};

}  // namespace test_support
