// The options of csgscope check.
#pragma once

#include <string>
#include <vector>

#include "ui/command_line/options.h"
#include "ui/pipeline/inspection/findings.h"

namespace ui {

enum class CheckFormat { Text, Json, Sarif, Junit };

struct CheckOptions {
    Options run;  ///< Of the program: its file, definitions, parameter sets, parts, time.
    CheckRequest request;
    CheckFormat format = CheckFormat::Text;
    std::string output = "-";
    std::string report;  ///< Folder; empty: none.
    bool help = false;   ///< Was asked for, and printed.
};

/// Throws UsageError.
[[nodiscard]] CheckOptions read_check_options(const std::vector<std::string>& arguments);

}  // namespace ui
