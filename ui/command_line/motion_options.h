// The options of csgscope motion.
#pragma once

#include <string>
#include <vector>

#include "ui/command_line/options.h"
#include "ui/pipeline/motion/motion.h"

namespace ui {

struct MotionOptions {
    Options run;  ///< Of the program: its file, definitions, parameter sets, time.
    MotionRequest request;
    bool json = false;
    std::string output = "-";
    bool help = false;  ///< Was asked for, and printed.
};

/// Throws UsageError.
[[nodiscard]] MotionOptions read_motion_options(const std::vector<std::string>& arguments);

}  // namespace ui
