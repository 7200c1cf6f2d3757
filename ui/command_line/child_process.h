// Other programs.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace ui {

/// Another program, in a process that is ended where the thread that began it ends first, in whatever way. It leads a
/// process group of its own.
class ChildProcess {
  public:
    /// Looked for in PATH. `out`: its standard output, and the rest that it prints is dropped; -1: it prints where this
    /// program does. `at_end`: the signal that ends it.
    ChildProcess(std::vector<std::string> command, int out, int at_end);
    /// Ends it where nobody has waited for that.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Waits for its end, and gives the status as waitpid does; -1 where it could not be started.
    [[nodiscard]] int wait();

  private:
    pid_t pid_ = -1;
    int at_end_;
};

}  // namespace ui
