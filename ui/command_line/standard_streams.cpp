#include "ui/command_line/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "base/write_all.h"

namespace ui {

void hold_standard_streams() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(fd, F_GETFD) == -1 && errno == EBADF) {
            // The lowest number that is free: this one. Open the wrong way around, so that using it is an error still.
            const int held = open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
            if (held != fd && held >= 0) {
                close(held);
            }
        }
    }
}

void say(std::string_view text) {
    static constinit std::atomic<int> patience = 2000;  // Milliseconds; a reader that has let that pass is not there.
    if (!base::write_all(STDERR_FILENO, text, patience) && errno == EAGAIN) {
        patience = 0;
    }
}

void write_standard_output(std::string_view bytes) {
    if (!base::write_all(STDOUT_FILENO, bytes)) {
        throw std::runtime_error(std::string("cannot write to standard output: ") + std::strerror(errno));
    }
}

}  // namespace ui
