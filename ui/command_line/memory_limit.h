// The memory that a run may take.
#pragma once

#include <cstddef>

namespace ui {

/// From now on the kernel refuses more than `bytes` for all that the process holds, which ends in std::bad_alloc. What
/// it limits is the heap, so the code that is in memory by now is taken off: to be called again at each stage, as more
/// of it comes in. Programs that this one runs inherit the limit.
void limit_memory(std::size_t bytes);

}  // namespace ui
