// A motion, told.
#pragma once

#include <string>

#include "ui/pipeline/json.h"
#include "ui/pipeline/motion/motion.h"

namespace ui {

struct MotionReport {
    const Motion& motion;
    const MotionRequest& request;
    const std::string& file;
};

/// A line or two for each body.
[[nodiscard]] std::string motion_text(const MotionReport& report);

/// With each body's pose in all samples. Matrices are four rows, and take the body from where it was at first.
[[nodiscard]] Json motion_json(const MotionReport& report);

}  // namespace ui
