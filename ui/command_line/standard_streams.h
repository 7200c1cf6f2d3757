// Standard input, output and error, whatever state they are in.
#pragma once

#include <string_view>

namespace ui {

/// Gives those that are closed something that can be neither read nor written, so that no file that is opened later
/// gets their number. To be called first in main().
void hold_standard_streams();

/// Writes to standard error. Nobody may be reading, or it may be full: what cannot be written is dropped, after a
/// moment's wait where it is a pipe that others made non-blocking. Takes no memory.
void say(std::string_view text);

/// Writes to standard output. Throws std::runtime_error with the reason.
void write_standard_output(std::string_view bytes);

}  // namespace ui
