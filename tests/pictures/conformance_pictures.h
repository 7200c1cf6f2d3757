// OpenSCAD's own suite, its pictures of rendered results: drawn by csgscope as the suite's command lines say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace pictures {

struct Case {
    std::string name;
    std::string input;                   ///< Below the working copy.
    std::vector<std::string> arguments;  ///< "@ROOT@" stands for the working copy.
    std::filesystem::path expected;
};

/// The cases of the kind `render`; none where the suite is absent.
[[nodiscard]] std::vector<Case> cases();

/// A copy of the suite's inputs in a folder of its own, which goes with it. Absolute paths in programs, which name the
/// folder where the suite was recorded, name the copy.
class WorkingCopy {
  public:
    WorkingCopy();
    [[nodiscard]] std::string root() const { return folder_.path("suite"); }

  private:
    test_support::TemporaryFolder folder_;
};

struct Result {
    double overlap = 0;   ///< Intersection over union of the silhouettes.
    std::string problem;  ///< Why there is no picture; empty where there is one.
    double seconds = 0;   ///< Of the whole process, wall time.
    [[nodiscard]] bool good() const { return problem.empty() && overlap >= 0.99; }
};

/// Draws a case with the program into `picture` (a PNG file) and compares; at most a minute.
[[nodiscard]] Result draw(const std::string& program, const Case& c, const WorkingCopy& copy,
                          const std::filesystem::path& picture);

/// All of them, on two threads; pictures are kept as NAME.png in `folder`.
[[nodiscard]] std::vector<Result> draw(const std::string& program, const std::vector<Case>& cases,
                                       const std::filesystem::path& folder);

}  // namespace pictures
