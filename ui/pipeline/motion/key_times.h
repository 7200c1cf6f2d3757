// The times at which a motion changes most: what a storyboard shows.
#pragma once

#include <string>
#include <vector>

#include "ui/pipeline/motion/motion.h"

namespace ui {

/// `count` times, increasing, of the motion's samples or half way between such: the first, the last where it is not as
/// the first, and one after another that at which a body is farthest from where the screw from the key before it to the
/// key behind it has it (Douglas and Peucker 1973, for motions). Where none is, the longest interval is halved.
[[nodiscard]] std::vector<double> key_times(const Motion& motion, int count);

/// What moves from one time to another: "door ×2 turns, drawer slides"; the bodies that move farthest first, at most
/// `most`, and how many more there are. Empty where nothing does.
[[nodiscard]] std::string what_moves(const Motion& motion, double from, double to, std::size_t most = 2);

}  // namespace ui
