// A thread with a deep stack: programs recurse as far as they are allowed to.
#pragma once

#include <cstddef>
#include <functional>

namespace csg::scad {

/// Runs `work`, which must not throw, on a thread of its own with `stack_bytes` of stack, as far as these make sense,
/// and waits for it. It is given the address below which the stack is used up, but for a reserve. False where there is
/// no such thread to be had.
[[nodiscard]] bool run_deep(std::size_t stack_bytes, const std::function<void(const char* stack_limit)>& work);

}  // namespace csg::scad
