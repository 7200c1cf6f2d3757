// Writing to a file descriptor, whatever kind it is.
#pragma once

#include <string_view>

namespace base {

inline constexpr int kPatient = -1;

/// Writes all the bytes. Where the descriptor is non-blocking (a pipe of another program's), waits while nothing can be
/// written, `patience` milliseconds at a time at most (kPatient: without end). No signal comes of a reader that is gone
/// or of a file that grows too large. False where not all could be written; errno says why.
[[nodiscard]] bool write_all(int fd, std::string_view bytes, int patience = kPatient);

}  // namespace base
