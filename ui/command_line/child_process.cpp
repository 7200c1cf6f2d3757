#include "ui/command_line/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>

#include "base/program_arguments.h"

namespace ui {

ChildProcess::ChildProcess(std::vector<std::string> command, int out, int at_end) : at_end_(at_end) {
    const std::vector<char*> arguments = base::program_arguments(command);
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ != 0) {
        return;
    }
    prctl(PR_SET_PDEATHSIG, at_end);
    setpgid(0, 0);
    if (out >= 0) {
        dup2(out, STDOUT_FILENO);
        dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
    }
    if (getppid() == parent) {
        execvp(arguments[0], arguments.data());
    }
    _exit(127);
}

ChildProcess::~ChildProcess() {
    if (pid_ > 0) {
        kill(pid_, at_end_);
        (void)wait();
    }
}

int ChildProcess::wait() {
    const pid_t pid = std::exchange(pid_, -1);
    int status = 0;
    pid_t ended = -1;
    while (pid > 0 && (ended = waitpid(pid, &status, 0)) < 0 && errno == EINTR) {
    }
    return ended > 0 ? status : -1;
}

}  // namespace ui
