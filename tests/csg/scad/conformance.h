// OpenSCAD's own suite as data, where this machine has it (see CONTRIBUTING): programs with what must come out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace conformance {

struct Case {
    std::string name;
    std::string kind;  ///< "echo", "csg" or "lazyunion", whose texts are .csg
    std::filesystem::path input;
    std::filesystem::path expected;
    std::vector<std::string> arguments;  ///< Of the command line.
};

/// Empty where the suite is absent.
[[nodiscard]] std::vector<Case> cases();

/// Runs a case; empty where it passes, else the first difference.
[[nodiscard]] std::string difference(const Case& c);

}  // namespace conformance
