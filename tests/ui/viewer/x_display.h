// An X server without a screen of its own, a program on it, and a robot at its keyboard and mouse.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"

namespace ui {

/// A child process; ended with this.
class Process {
  public:
    /// Starts `arguments[0]`, found in PATH, with its output in the file `output`. `environment`: NAME=VALUE over the
    /// parent's, or NAME to take it away. `pass_descriptor`: one that the child keeps, -1 for none.
    Process(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
            const std::string& output, int pass_descriptor = -1);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// The exit status; none where it runs on.
    [[nodiscard]] std::optional<int> wait(std::chrono::seconds most);
    /// Ends it as nothing can that it could answer.
    void kill_at_once();
    /// Processor time it has used, in seconds.
    [[nodiscard]] double processor_seconds() const;
    /// Main memory that it holds.
    [[nodiscard]] std::size_t resident_bytes() const;

  private:
    pid_t pid_ = -1;
    std::optional<int> status_;
};

class XDisplay {
  public:
    /// The first of the programs it needs that is not there; empty where all are.
    [[nodiscard]] static std::string missing_program();

    /// Starts Xvfb on a free display. Throws std::runtime_error.
    explicit XDisplay(std::string folder);

    [[nodiscard]] const std::string& name() const { return name_; }  ///< ":7"
    /// Runs xdotool, such as "key s".
    void robot(const std::string& commands) const;
    [[nodiscard]] base::Image screenshot() const;

  private:
    std::string folder_;
    int pipe_[2] = {-1, -1};
    std::optional<Process> server_;
    std::string name_;
};

}  // namespace ui
